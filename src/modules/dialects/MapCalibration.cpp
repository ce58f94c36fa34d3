#include "dialects/MapCalibration.hpp"

#include "dialects/MountAngles.hpp"
#include "dialects/text/Decimals.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"
#include "protocol/JointOrder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>

namespace naocal {
namespace {

struct CameraNames {
  const char *ours, *theirs;
};
constexpr std::array mapCameras{CameraNames{"top", "upper"}, CameraNames{"bottom", "lower"}};

/// HULKs' name of a joint in these files; absent for another word.
std::optional<std::string> jointOf(const std::string& key) {
  for (const std::string_view joint : jointNames) {
    if (offsetKey(joint) == key) {
      return std::string{joint};
    }
  }
  return std::nullopt;
}

/// One file's text on its way into a calibration.
class MapCalibrationReader {
public:
  explicit MapCalibrationReader(const std::string& file) : file_{file} {}

  ParsedCalibration read(const MapText& all) {
    for (const auto& [name, value] : all.members) {
      isKnown_ |= readMember(name, value, all);
    }
    if (!isKnown_) {
      throw InputError{fmt::format("{}: expected joint offsets, camera corrections or lenses of B-Human or Nao Devils "
                                   "(offsets = {{...}}, cameraRotationCorrections = {{...}}, ...), found {}",
                                   file_, all.members.empty() ? "nothing" : all.members.front().name + " = ...")};
    }
    return std::move(parsed_);
  }

private:
  [[noreturn]] void refuse(const MapText& at, const std::string& name, std::string_view expected,
                           std::string_view found) const {
    throw InputError{fmt::format("{}: line {}: {}: expected {}, found {}", file_, at.line, name, expected, found)};
  }

  void unused(const MapText& at, const std::string& name) {
    parsed_.unused.push_back(fmt::format("{} in line {}", name, at.line));
  }

  const MapText& member(const MapText& map, const std::string& name, const std::string& key) const {
    const MapText* found = map.find(key);
    if (found == nullptr) {
      refuse(map, name, fmt::format("{} = ... in it", key), "none");
    }
    return *found;
  }

  double angle(const MapText& value, const std::string& name) const {
    const double read = mapAngle(value, name, file_);
    if (std::abs(read) > std::numbers::pi) {
      refuse(value, name, "an angle within 180 degrees (is its unit missing?)", fmt::format("\"{}\"", value.literal));
    }
    return read;
  }

  /// True if the member is a part of a calibration.
  bool readMember(const std::string& name, const MapText& value, const MapText& all) {
    if (name == "offsets") {
      readOffsets(value, name, false);
    } else if (name == "joints") {
      readOffsets(value, name, true);
    } else if (jointOf(name)) {
      readOffset(name, value, true);
    } else if (name == "bodyRotationCorrection") {
      readBody(value, name);
    } else if (name == "cameraRotationCorrections") {
      readNamed(value, name, [this](const std::string& camera, const MapText& at, const std::string& path) {
        readCorrection(camera, at, path);
      });
    } else if (name == "cameras") {
      readNamed(value, name, [this](const std::string& camera, const MapText& at, const std::string& path) {
        readLens(camera, member(at, path, "openingAngleWidth"), member(at, path, "openingAngleHeight"),
                 member(at, path, "opticalCenter"));
      });
    } else {
      return readCameraMember(name, value, all);
    }
    return true;
  }

  /// Members with the camera in their name, as in older files.
  bool readCameraMember(const std::string& name, const MapText& value, const MapText& all) {
    for (const CameraNames& camera : mapCameras) {
      const std::string prefix = camera.theirs;
      if (name == prefix + "CameraRotationCorrection") {
        readCorrection(camera.ours, value, name);
        return true;
      }
      if (name == prefix + "OpeningAngleWidth") {
        const std::string where = "this file";
        readLens(camera.ours, value, member(all, where, prefix + "OpeningAngleHeight"),
                 member(all, where, prefix + "OpticalCenter"));
        return true;
      }
      if (name == prefix + "OpeningAngleHeight" || name == prefix + "OpticalCenter") {
        (void)member(all, "this file", prefix + "OpeningAngleWidth");
        return true;
      }
    }
    unused(value, name);
    return false;
  }

  template <typename Read> void readNamed(const MapText& map, const std::string& name, const Read& read) {
    for (const auto& [key, value] : map.members) {
      const auto camera = std::find_if(mapCameras.begin(), mapCameras.end(),
                                       [&, &word = key](const CameraNames& each) { return word == each.theirs; });
      if (camera == mapCameras.end()) {
        refuse(value, name, "upper or lower", key.empty() ? "a list" : key);
      }
      read(camera->ours, value, name + "." + key);
    }
  }

  void readOffsets(const MapText& map, const std::string& name, bool withLimits) {
    if (map.kind != MapText::Kind::map) {
      refuse(map, name, "{ joint = angle; ... }", "something else");
    }
    for (const auto& [key, value] : map.members) {
      if (!jointOf(key)) {
        refuse(value, name, "joints of a NAO, such as lKneePitch", key);
      }
      readOffset(key, value, withLimits);
    }
  }

  void readOffset(const std::string& key, const MapText& value, bool withLimits) {
    const MapText& offset = withLimits ? member(value, key, "offset") : value;
    addOffset(*jointOf(key), angle(offset, key), parsed_);
  }

  void readBody(const MapText& value, const std::string& name) {
    for (const auto& [key, at] : value.members) {
      if (angle(at, name + "." + key) != 0) {
        unused(at, name + "." + key);
      }
    }
  }

  void readCorrection(const std::string& camera, const MapText& value, const std::string& name) {
    Eigen::Vector3d angles;
    for (int i = 0; i < 3; ++i) {
      const std::string key(1, "xyz"[i]);
      angles[i] = angle(member(value, name, key), name + "." + key);
    }
    parsed_.calibration.cameras[camera].rotation = anglesXyz(rotationYxz(angles));
  }

  double focal(const MapText& value, int pixels) const {
    constexpr double narrowest = radians(5), widest = radians(170);
    const double opening = mapAngle(value, "the opening angle", file_);
    if (opening < narrowest || opening > widest) {
      refuse(value, "the opening angle", "5deg to 170deg, with its unit", fmt::format("\"{}\"", value.literal));
    }
    return pixels / (2 * std::tan(opening / 2));
  }

  void readLens(const std::string& camera, const MapText& width, const MapText& height, const MapText& centre) {
    CameraIntrinsics lens;
    lens.fx = focal(width, lens.width);
    lens.fy = focal(height, lens.height);
    lens.cx = mapNumber(member(centre, "the optical centre", "x"), "the optical centre", file_) * lens.width;
    lens.cy = mapNumber(member(centre, "the optical centre", "y"), "the optical centre", file_) * lens.height;
    parsed_.calibration.cameras[camera].lens = lens;
  }

  const std::string& file_;
  ParsedCalibration parsed_;
  bool isKnown_ = false;
};

std::string degreesText(double angle) {
  return printDecimal(degrees(angle), decimals::degree) + "deg";
}

} // namespace

std::vector<std::string_view> mapJoints() {
  return {"HeadYaw",     "HeadPitch",  "LShoulderPitch", "LShoulderRoll", "LElbowYaw", "LElbowRoll",
          "LWristYaw",   "LHand",      "RShoulderPitch", "RShoulderRoll", "RElbowYaw", "RElbowRoll",
          "RWristYaw",   "RHand",      "LHipYawPitch",   "LHipRoll",      "LHipPitch", "LKneePitch",
          "LAnklePitch", "LAnkleRoll", "RHipYawPitch",   "RHipRoll",      "RHipPitch", "RKneePitch",
          "RAnklePitch", "RAnkleRoll"};
}

ParsedCalibration parseMapCalibration(std::string_view text, const std::string& file) {
  return MapCalibrationReader{file}.read(parseMapText(text, file));
}

std::string mapOffset(const RobotCalibration& calibration, std::string_view joint) {
  return degreesText(findOffset(calibration, joint).value_or(0));
}

std::string jointsWithLimits(const RobotCalibration& calibration, const Robot& robot, std::string_view indent,
                             std::string_view handMaximum) {
  std::string text;
  for (const std::string_view joint : mapJoints()) {
    const auto index = robot.jointIndex(joint);
    const std::string lowest = index ? degreesText(robot.joints[*index].limits.lower) : "0deg";
    const std::string highest = index ? degreesText(robot.joints[*index].limits.upper) : std::string{handMaximum};
    text += fmt::format("{0}{1} = {{\n{0}  offset = {2};\n{0}  minAngle = {3};\n{0}  maxAngle = {4};\n{0}}};\n", indent,
                        offsetKey(joint), mapOffset(calibration, joint), lowest, highest);
  }
  return text;
}

std::string mapCorrection(const RobotCalibration& calibration, const std::string& camera) {
  const auto found = calibration.cameras.find(camera);
  const bool isKnown = found != calibration.cameras.end() && found->second.rotation;
  const Eigen::Vector3d angles =
      isKnown ? anglesYxz(rotationXyz(*found->second.rotation)) : Eigen::Vector3d{Eigen::Vector3d::Zero()};
  return fmt::format("{{x = {}; y = {}; z = {};}}", degreesText(angles.x()), degreesText(angles.y()),
                     degreesText(angles.z()));
}

MapLens mapLens(const CameraIntrinsics& lens) {
  const auto share = [](double pixels, int all) { return printDecimal(pixels / all, decimals::share); };
  return {degreesText(2 * std::atan(lens.width / (2 * lens.fx))),
          degreesText(2 * std::atan(lens.height / (2 * lens.fy))),
          fmt::format("{{x = {}; y = {};}}", share(lens.cx, lens.width), share(lens.cy, lens.height))};
}

} // namespace naocal
