#include "dialects/HulksTree.hpp"

#include "dialects/MountAngles.hpp"
#include "dialects/text/Decimals.hpp"
#include "dialects/text/JsonText.hpp"
#include "math/Angles.hpp"
#include "math/RigidTransform.hpp"
#include "protocol/JointOrder.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>

namespace naocal {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* offsetsKey = "joint_calibration_offsets";
constexpr const char* camerasKey = "camera_matrix_parameters";

/// A joint's place in the tree: ("left_leg", "hip_yaw_pitch").
std::pair<std::string, std::string> placeOf(std::string_view joint) {
  const bool isHead = joint.starts_with("Head");
  const std::string_view part = joint.substr(isHead ? 4 : 1);
  std::string key;
  for (const char letter : part) {
    const bool isCapital = letter >= 'A' && letter <= 'Z';
    key += isCapital && !key.empty() ? "_" : "";
    key += isCapital ? static_cast<char>(letter - 'A' + 'a') : letter;
  }
  if (isHead) {
    return {"head", key};
  }
  const bool isLeg = part.starts_with("Hip") || part.starts_with("Knee") || part.starts_with("Ankle");
  return {fmt::format("{}_{}", joint.front() == 'L' ? "left" : "right", isLeg ? "leg" : "arm"), key};
}

/// Angles of R in opticalFromHead = R * nominal from those of our mount, and back. With A = opticalFromCamera:
/// R = A * (Rx Ry Rz)^T * A^T.
Eigen::Vector3d treeAngles(const Eigen::Vector3d& ours) {
  const Eigen::Matrix3d axes = opticalFromCamera();
  return anglesZyx(axes * rotationXyz(ours).transpose() * axes.transpose());
}
Eigen::Vector3d ourAngles(const Eigen::Vector3d& tree) {
  const Eigen::Matrix3d axes = opticalFromCamera();
  return anglesXyz(axes.transpose() * rotationZyx(tree).transpose() * axes);
}

Json cameraJson(const CameraCalibration& camera) {
  Json one = Json::object();
  if (camera.rotation) {
    one["extrinsic_rotations"] =
        roundedList(Eigen::Vector3d{treeAngles(*camera.rotation) * degrees(1.0)}, decimals::degree);
  }
  if (camera.lens) {
    const LensShares shares = sharesOf(*camera.lens);
    one["focal_lengths"] = roundedList(shares.focal, decimals::share);
    one["cc_optical_center"] = roundedList(shares.centre, decimals::share);
  }
  return one;
}

void readOffsets(const JsonCursor& at, ParsedCalibration& parsed) {
  std::size_t found = 0, given = 0;
  for (const auto& [limb, members] : at.members()) {
    given += members.members().size();
  }
  for (const std::string_view joint : jointNames) {
    const auto [limb, key] = placeOf(joint);
    const auto members = at.find(limb);
    if (const auto offset = members ? members->find(key) : std::nullopt) {
      addOffset(std::string{joint}, offset->number({-3.2, 3.2, "rad"}), parsed);
      ++found;
    }
  }
  if (found < given) {
    at.refuse("limbs and joints such as left_leg.knee_pitch alone", "another name");
  }
}

void readCamera(const JsonCursor& at, CameraCalibration& camera) {
  if (const auto angles = at.find("extrinsic_rotations")) {
    const Eigen::Vector3d tree{angles->numbers(3, {-180, 180, "degrees"}, "about the optical axes").data()};
    camera.rotation = ourAngles(tree * radians(1.0));
  }
  if (at.find("focal_lengths") || at.find("cc_optical_center")) {
    camera.lens = readLensShares(at.at("focal_lengths"), at.at("cc_optical_center"));
  }
}

/// What of the cameras' part does not belong to them, except for the pitches of the drawing.
void readCameras(const JsonCursor& at, ParsedCalibration& parsed) {
  for (const auto& [key, value] : at.members()) {
    if (key == "vision_top" || key == "vision_bottom") {
      readCamera(value, parsed.calibration.cameras[key == "vision_top" ? "top" : "bottom"]);
    } else {
      parsed.unused.push_back(fmt::format("{}.{}", camerasKey, key));
    }
  }
}

std::string fileName(std::string_view part, const std::string& id) {
  return id.empty() ? fmt::format("{}.json", part) : fmt::format("{}.{}.json", part, id);
}

} // namespace

std::vector<DialectFile> writeHulksTree(const RobotCalibration& calibration, const Robot&) {
  Json offsets = Json::object(), cameras = Json::object();
  for (const std::string_view joint : jointNames) {
    if (const auto offset = findOffset(calibration, joint)) {
      const auto [limb, key] = placeOf(joint);
      offsets[limb][key] = roundDecimal(*offset, decimals::radian);
    }
  }
  for (const char* const name : {"top", "bottom"}) {
    const auto camera = calibration.cameras.find(name);
    if (camera != calibration.cameras.end() && (camera->second.rotation || camera->second.lens)) {
      cameras[fmt::format("vision_{}", name)] = cameraJson(camera->second);
    }
  }
  std::vector<DialectFile> files;
  if (!offsets.empty()) {
    files.push_back({fileName("body", calibration.bodyId), Json{{offsetsKey, offsets}}.dump(2) + "\n"});
  }
  if (!cameras.empty()) {
    files.push_back({fileName("head", calibration.headId), Json{{camerasKey, cameras}}.dump(2) + "\n"});
  }
  return files;
}

ParsedCalibration parseHulksTree(const std::string& text, const std::string& file, const Robot&) {
  const nlohmann::json document = parseCommentedJson(text, file);
  const JsonCursor all{document, file};
  ParsedCalibration parsed;
  const auto offsets = all.find(offsetsKey), cameras = all.find(camerasKey);
  if (!offsets && !cameras) {
    all.refuse(fmt::format("{} or {}", offsetsKey, camerasKey), "none of them");
  }
  if (offsets) {
    readOffsets(*offsets, parsed);
  }
  if (cameras) {
    readCameras(*cameras, parsed);
  }
  for (const auto& [key, value] : document.items()) {
    if (key != offsetsKey && key != camerasKey) {
      parsed.unused.push_back(key);
    }
  }
  return parsed;
}

} // namespace naocal
