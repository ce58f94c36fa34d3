#include "brain/HeadCalibration.hpp"

#include "geometry/Angles.hpp"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

constexpr const char* offsetsMount = "Motion.JointCalibrationProvider";
constexpr const char* camerasMount = "Brain.Projection";

} // namespace

std::vector<CompensatedAngles> headPoses(const CompensatedAngles& stand, const std::vector<double>& yaws,
                                         const std::vector<double>& pitches) {
  std::vector<CompensatedAngles> poses;
  bool backwards = false;
  for (const double pitch : pitches) {
    std::vector<double> row = yaws;
    if (backwards) {
      std::reverse(row.begin(), row.end());
    }
    backwards = !backwards;
    for (const double yaw : row) {
      poses.push_back(stand);
      poses.back()[*jointNumber("HeadYaw")] = radians(yaw);
      poses.back()[*jointNumber("HeadPitch")] = radians(pitch);
    }
  }
  return poses;
}

StoredResult ofHead(StoredResult result) {
  std::erase_if(result.terms, [](const std::string& term) {
    return !term.starts_with("jointOffset@Head") && !term.starts_with("cameraRotation@");
  });
  return result;
}

void apply(const StoredResult& result, Configuration& configuration) {
  for (const std::string& term : result.terms) {
    const std::string effect = term.substr(0, term.find('@')), place = term.substr(term.find('@') + 1);
    if (effect == "jointOffset") {
      std::string key = place;
      key[0] = static_cast<char>(std::tolower(key[0]));
      configuration.set(offsetsMount, key, degrees(result.values.at(term + ".o")));
    }
    if (effect == "cameraRotation") {
      configuration.set(
          camerasMount, place + "_ext",
          {result.values.at(term + ".rx"), result.values.at(term + ".ry"), result.values.at(term + ".rz")});
    }
  }
  configuration.save();
}

void takeBack(Configuration& configuration) {
  configuration.undo(offsetsMount);
  configuration.undo(camerasMount);
}

} // namespace naocal
