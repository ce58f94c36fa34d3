#include "dialects/SavedCalibration.hpp"

#include "effects/Catalogue.hpp"
#include "math/Angles.hpp"
#include "protocol/JointOrder.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

constexpr const char* offsetsMount = "Motion.JointCalibrationProvider";
constexpr const char* camerasMount = "Brain.Projection";
const std::vector<std::string> calibrationMounts{offsetsMount, camerasMount};
constexpr std::array mountAngles{"rx", "ry", "rz"};

std::string mountKey(const std::string& camera) {
  return camera + "_ext";
}

} // namespace

std::vector<EffectiveOffset> headOffsets(std::vector<EffectiveOffset> offsets) {
  std::erase_if(offsets, [](const EffectiveOffset& offset) { return !offset.joint.starts_with("Head"); });
  return offsets;
}

StoredResult readConfiguredCalibration(const Configuration& configuration) {
  StoredResult result;
  nlohmann::json offsets, mounts;
  configuration.readKeys(offsetsMount, offsets);
  configuration.readKeys(camerasMount, mounts);
  for (const std::string_view joint : jointNames) {
    if (joint != "RHipYawPitch" && !joint.ends_with("Hand")) { // coupled joint, and joints without an angle
      const std::string term = fmt::format("jointOffset@{}", joint);
      result.terms.push_back(term);
      result.values[term + ".o"] = radians(offsets.at(offsetKey(joint)).get<double>());
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

std::map<std::string, double> readConfiguredOffsets(const Configuration& configuration) {
  std::map<std::string, double> offsets;
  const StoredResult configured = readConfiguredCalibration(configuration);
  for (const std::string& term : configured.terms) {
    if (const auto [effect, joint] = std::pair{term.substr(0, term.find('@')), term.substr(term.find('@') + 1)};
        effect == effectName::jointOffset) {
      offsets[joint] = configured.values.at(term + ".o");
    }
  }
  return offsets;
}

std::string snapshotCalibration(const Configuration& configuration) {
  nlohmann::json all;
  for (const std::string& mount : calibrationMounts) {
    configuration.readKeys(mount, all[mount]);
  }
  return all.dump();
}

void restoreCalibration(const std::string& calibrationKeys, Configuration& configuration) {
  const auto now = nlohmann::json::parse(naocal::snapshotCalibration(configuration));
  const auto before = nlohmann::json::parse(calibrationKeys);
  for (const auto& [mount, keys] : before.items()) {
    for (const auto& [key, value] : keys.items()) {
      if (now.at(mount).value(key, nlohmann::json{}) != value) {
        configuration.set(mount, key, value);
      }
    }
  }
}

void applyCalibration(const std::vector<EffectiveOffset>& offsets, const StoredResult& mounts,
                      Configuration& configuration) {
  const std::string before = snapshotCalibration(configuration);
  try {
    for (const EffectiveOffset& offset : offsets) {
      configuration.set(offsetsMount, offsetKey(offset.joint), degrees(offset.value));
      if (offset.joint == "LHipYawPitch") {
        configuration.set(offsetsMount, offsetKey("RHipYawPitch"), degrees(offset.value));
      }
    }
    for (const std::string& term : mounts.terms) {
      const std::string effect = term.substr(0, term.find('@')), place = term.substr(term.find('@') + 1);
      if (effect == effectName::cameraRotation) {
        nlohmann::json rotation;
        for (const char* angle : mountAngles) {
          rotation.push_back(mounts.values.at(term + "." + angle));
        }
        configuration.set(camerasMount, mountKey(place), rotation);
      }
    }
  } catch (...) {
    restoreCalibration(before, configuration);
    throw;
  }
}

void applyLens(const std::string& camera, const CameraIntrinsics& lens, Configuration& configuration) {
  configuration.set(camerasMount, camera + "_fc", {lens.fx / lens.width, lens.fy / lens.height});
  configuration.set(camerasMount, camera + "_cc", {lens.cx / lens.width, lens.cy / lens.height});
}

void mountCalibration(Configuration& configuration) {
  configuration.mount(
      offsetsMount, "JointCalibrationProvider.json", RobotPart::body,
      [](const std::string& key, const nlohmann::json& value) {
        const bool isOffset = std::any_of(jointNames.begin(), jointNames.end(),
                                          [&](std::string_view joint) { return offsetKey(joint) == key; });
        if (!isOffset) {
          return;
        }
        if (!value.is_number() || !(std::abs(value.get<double>()) <= largestOffset)) {
          throw ConfigurationError{fmt::format("{}: expected an offset from -{} to {} degrees, found {}", key,
                                               largestOffset, largestOffset, value.dump())};
        }
      });
  configuration.mount(camerasMount, "Projection.json", RobotPart::head);
  saveCalibrationTogether(configuration);
}

void saveCalibrationTogether(Configuration& configuration) {
  configuration.saveTogether(calibrationMounts);
}

bool isCalibrationSaved(const Configuration& configuration) {
  return std::all_of(calibrationMounts.begin(), calibrationMounts.end(),
                     [&](const std::string& mount) { return configuration.isSaved(mount); });
}

void saveCalibration(Configuration& configuration) {
  configuration.save(offsetsMount);
}

void undoCalibration(Configuration& configuration) {
  configuration.undo(offsetsMount);
}

} // namespace naocal
