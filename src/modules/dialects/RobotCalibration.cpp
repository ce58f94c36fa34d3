#include "dialects/RobotCalibration.hpp"

#include "io/FileVersion.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"
#include "math/Angles.hpp"
#include "protocol/JointOrder.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

using nlohmann::json;

namespace {

constexpr const char* leftHip = "LHipYawPitch";
constexpr const char* rightHip = "RHipYawPitch";
constexpr const char* calibrationFormat = "naocal-calibration";

json list(const Eigen::Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

json lensJson(const CameraIntrinsics& lens) {
  return {{"width", lens.width}, {"height", lens.height},        {"fx", lens.fx}, {"fy", lens.fy}, {"cx", lens.cx},
          {"cy", lens.cy},       {"distortion", lens.distortion}};
}

CameraIntrinsics lensFrom(const JsonCursor& at) {
  constexpr Range focal{1, 1e5, "px"}, centre{-1e5, 1e5, "px"};
  CameraIntrinsics lens;
  lens.width = at.at("width").integer(1, CameraIntrinsics::mostPixels);
  lens.height = at.at("height").integer(1, CameraIntrinsics::mostPixels);
  lens.fx = at.at("fx").number(focal);
  lens.fy = at.at("fy").number(focal);
  lens.cx = at.at("cx").number(centre);
  lens.cy = at.at("cy").number(centre);
  const auto distortion = at.at("distortion").numbers(5, {-100, 100, ""}, "k1, k2, p1, p2, k3");
  std::copy(distortion.begin(), distortion.end(), lens.distortion.begin());
  return lens;
}

Eigen::Vector3d vectorFrom(const JsonCursor& at, const Range& range, std::string_view why) {
  return Eigen::Vector3d{at.numbers(3, range, why).data()};
}

template <typename Value>
void addOnce(const std::optional<Value>& other, const std::string& what, const std::string& file,
             std::optional<Value>& all) {
  if (other && all) {
    throw InputError{fmt::format("{}: {} is in another of these files too; name one file of each kind", file, what)};
  }
  all = other ? other : all;
}

} // namespace

std::vector<std::string_view> offsetJoints() {
  std::vector<std::string_view> names;
  for (const std::string_view joint : jointNames) {
    if (joint != rightHip && !joint.ends_with("Hand")) {
      names.push_back(joint);
    }
  }
  return names;
}

std::optional<double> findOffset(const RobotCalibration& calibration, std::string_view joint) {
  const auto found = calibration.offsets.find(joint == "RHipYawPitch" ? "LHipYawPitch" : std::string{joint});
  return found == calibration.offsets.end() ? std::nullopt : std::optional{found->second};
}

void addOffset(const std::string& joint, double offset, ParsedCalibration& parsed) {
  constexpr double rounding = 1e-8; // [rad], of the digits in files
  auto& offsets = parsed.calibration.offsets;
  if (joint.ends_with("Hand")) {
    if (offset != 0) {
      parsed.unused.push_back(fmt::format("the offset of {}: hands have no angle", joint));
    }
    return;
  }
  const auto other = offsets.find(leftHip);
  if (joint != leftHip && joint != rightHip) {
    offsets[joint] = offset;
  } else if (other == offsets.end()) {
    offsets[leftHip] = offset;
  } else {
    if (std::abs(other->second - offset) > rounding) {
      parsed.unused.push_back(fmt::format("{} ({:.4f}°): it differs from the other hip yaw-pitch ({:.4f}°), but one "
                                          "motor drives both; the left one's counts",
                                          rightHip, degrees(joint == rightHip ? offset : other->second),
                                          degrees(joint == rightHip ? other->second : offset)));
    }
    other->second = joint == leftHip ? offset : other->second;
  }
}

void addCalibration(const ParsedCalibration& other, const std::string& file, ParsedCalibration& all) {
  for (const auto& [joint, offset] : other.calibration.offsets) {
    if (!all.calibration.offsets.emplace(joint, offset).second) {
      throw InputError{fmt::format("{}: the offset of {} is in another of these files too; name one file of each kind",
                                   file, joint)};
    }
  }
  for (const auto& [name, camera] : other.calibration.cameras) {
    CameraCalibration& present = all.calibration.cameras[name];
    addOnce(camera.rotation, "the rotation of camera " + name, file, present.rotation);
    addOnce(camera.translation, "the shift of camera " + name, file, present.translation);
    addOnce(camera.lens, "the lens of camera " + name, file, present.lens);
  }
  all.unused.insert(all.unused.end(), other.unused.begin(), other.unused.end());
}

RobotCalibration completeCalibration(RobotCalibration calibration, const RobotCalibration& present) {
  calibration.offsets.insert(present.offsets.begin(), present.offsets.end());
  for (const auto& [name, camera] : present.cameras) {
    CameraCalibration& own = calibration.cameras[name];
    own.rotation = own.rotation ? own.rotation : camera.rotation;
    own.translation = own.translation ? own.translation : camera.translation;
    own.lens = own.lens ? own.lens : camera.lens;
  }
  return calibration;
}

json calibrationJson(const RobotCalibration& calibration) {
  json cameras = json::object();
  for (const auto& [name, camera] : calibration.cameras) {
    json& one = cameras[name] = json::object();
    if (camera.rotation) {
      one["rotation"] = list(*camera.rotation);
    }
    if (camera.translation) {
      one["translation"] = list(*camera.translation);
    }
    if (camera.lens) {
      one["lens"] = lensJson(*camera.lens);
    }
  }
  json all = withFormat(calibrationFormat, {{"offsets", calibration.offsets}, {"cameras", std::move(cameras)}});
  if (!calibration.robot.empty()) {
    all["robot"] = calibration.robot;
  }
  if (!calibration.headId.empty()) {
    all["headId"] = calibration.headId;
  }
  if (!calibration.bodyId.empty()) {
    all["bodyId"] = calibration.bodyId;
  }
  return all;
}

RobotCalibration parseCalibration(const json& document, const std::string& name) {
  const JsonCursor all{document, name};
  if (all.at("format").text() != calibrationFormat) {
    all.at("format").refuse("\"naocal-calibration\" as 'naocal import' writes it");
  }
  requireVersion(all);
  constexpr Range angle{-3.2, 3.2, "rad"};
  RobotCalibration calibration;
  const auto robot = all.find("robot");
  calibration.robot = robot ? robot->text() : "";
  const auto known = offsetJoints();
  for (const auto& [joint, offset] : all.at("offsets").members()) {
    if (!robot && std::find(known.begin(), known.end(), joint) == known.end()) {
      offset.refuse("an offset of one of HULKs' joints, such as LKneePitch", joint);
    }
    calibration.offsets[joint] = offset.number(angle);
  }
  for (const auto& [camera, at] : all.at("cameras").members()) {
    CameraCalibration& one = calibration.cameras[camera];
    if (const auto rotation = at.find("rotation")) {
      one.rotation = vectorFrom(*rotation, angle, "rx, ry, rz");
    }
    if (const auto translation = at.find("translation")) {
      one.translation = vectorFrom(*translation, {-1, 1, "m"}, "x, y, z");
    }
    if (const auto lens = at.find("lens")) {
      one.lens = lensFrom(*lens);
    }
  }
  const auto headId = all.find("headId"), bodyId = all.find("bodyId");
  calibration.headId = headId ? headId->text() : "";
  calibration.bodyId = bodyId ? bodyId->text() : "";
  return calibration;
}

} // namespace naocal
