#include "brain/SavedCalibration.hpp"

#include "geometry/Angles.hpp"
#include "hardware/Joints.hpp"

#include <array>
#include <cctype>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

constexpr const char* offsetsMount = "Motion.JointCalibrationProvider";
constexpr const char* camerasMount = "Brain.Projection";
constexpr std::array mountAngles{"rx", "ry", "rz"};

std::string offsetKey(std::string joint) {
  joint[0] = static_cast<char>(std::tolower(joint[0]));
  return joint;
}

std::string mountKey(const std::string& camera) {
  return camera + "_ext";
}

} // namespace

StoredResult ofHead(StoredResult result) {
  std::erase_if(result.terms, [](const std::string& term) {
    return !term.starts_with("jointOffset@Head") && !term.starts_with("cameraRotation@");
  });
  return result;
}

StoredResult configured(const Configuration& configuration) {
  StoredResult result;
  nlohmann::json offsets, mounts;
  configuration.keys(offsetsMount, offsets);
  configuration.keys(camerasMount, mounts);
  for (const std::string_view joint : jointNames) {
    if (joint != "RHipYawPitch" && !joint.ends_with("Hand")) { // no motor of its own; no angle
      const std::string term = fmt::format("jointOffset@{}", joint);
      result.terms.push_back(term);
      result.values[term + ".o"] = radians(offsets.at(offsetKey(std::string{joint})).get<double>());
    }
  }
  for (const std::string camera : {"top", "bottom"}) {
    result.terms.push_back("cameraRotation@" + camera);
    for (std::size_t i = 0; i < mountAngles.size(); ++i) {
      result.values[result.terms.back() + "." + mountAngles[i]] = mounts.at(mountKey(camera)).at(i).get<double>();
    }
  }
  return result;
}

void apply(const StoredResult& result, Configuration& configuration) {
  for (const std::string& term : result.terms) {
    const std::string effect = term.substr(0, term.find('@')), place = term.substr(term.find('@') + 1);
    if (effect == "jointOffset") {
      const double offset = degrees(result.values.at(term + ".o"));
      configuration.set(offsetsMount, offsetKey(place), offset);
      if (place == "LHipYawPitch") {
        configuration.set(offsetsMount, offsetKey("RHipYawPitch"), offset);
      }
    }
    if (effect == "cameraRotation") {
      nlohmann::json rotation;
      for (const char* angle : mountAngles) {
        rotation.push_back(result.values.at(term + "." + angle));
      }
      configuration.set(camerasMount, mountKey(place), rotation);
    }
  }
  configuration.save();
}

void takeBack(Configuration& configuration) {
  configuration.undo(offsetsMount);
  configuration.undo(camerasMount);
}

} // namespace naocal
