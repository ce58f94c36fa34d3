#include "poses/PoseFile.hpp"

#include "data/BoardFile.hpp"
#include "data/CaptureSetFile.hpp"
#include "io/Files.hpp"
#include "io/JsonReader.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

/// The joint of a key, which the robot must have; absent: a finger.
std::optional<Eigen::Index> jointOf(const std::string& name, const JsonPlace& place, const Robot& robot) {
  if (std::find(fingers.begin(), fingers.end(), name) != fingers.end()) {
    return std::nullopt;
  }
  const auto joint = robot.jointIndex(name);
  if (!joint) {
    place.refuse(fmt::format("a joint of the {}", robot.model), fmt::format("\"{}\"", name));
  }
  return static_cast<Eigen::Index>(*joint);
}

Eigen::VectorXd anglesFrom(const JsonPlace& joints, const Robot& robot) {
  constexpr double rounding = 1e-6; // [rad]
  Eigen::VectorXd angles = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(robot.joints.size()), std::nan(""));
  for (const auto& [name, place] : joints.members()) {
    const double angle = place.number(angleRange);
    if (const auto joint = jointOf(name, place, robot)) {
      angles[*joint] = angle;
    }
  }
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const Joint& drawn = robot.joints[joint];
    const double angle = angles[static_cast<Eigen::Index>(joint)];
    if (std::isnan(angle)) {
      joints.refuse(fmt::format("an angle for each joint of the {}", robot.model), fmt::format("no {}", drawn.name));
    }
    const AngleRange limits = limitsAt(robot, joint, angles);
    if (angle < limits.lower - rounding || angle > limits.upper + rounding) {
      joints.at(drawn.name)
          .refuse(fmt::format("an angle from {:.4f} to {:.4f} radians, as the joint can take it", limits.lower,
                              limits.upper));
    }
    if (angle != angles[static_cast<Eigen::Index>(drawn.motor)]) {
      joints.at(drawn.name)
          .refuse(fmt::format("the angle of {}: one motor drives both", robot.joints[drawn.motor].name));
    }
  }
  return angles;
}

PlayablePose poseFrom(const JsonPlace& place, const Robot& robot) {
  PlayablePose pose;
  pose.id = place.at("id").text();
  pose.supportFoot = static_cast<SupportFoot>(place.at("supportFoot").oneOf({"left", "right", "both"}));
  pose.angles = anglesFrom(place.at("joints"), robot);
  pose.approach = Eigen::VectorXd::Zero(pose.angles.size());
  if (const auto approach = place.find("approach")) {
    for (const auto& [name, direction] : approach->members()) {
      const int sign = direction.integer(-1, 1);
      if (const auto joint = jointOf(name, direction, robot)) {
        pose.approach[*joint] = sign;
      }
    }
  }
  return pose;
}

} // namespace

PoseFile readPoseFile(const std::filesystem::path& file, const Robot& robot) {
  const nlohmann::json document = parseJson(fileContent(file), file.string());
  const JsonPlace all{document, file.string()};
  all.at("format").oneOf({"naocal-poses"});
  all.at("version").integer(1, 1);
  if (all.at("robot").text() != robot.model) {
    all.at("robot").refuse(fmt::format("poses for the {}", robot.model));
  }
  PoseFile result;
  if (const auto stance = all.find("firstStance")) {
    result.firstStance = stance->integer(0, 1'000'000);
  }
  if (const auto assumptions = all.find("assumptions")) {
    if (const auto jointError = assumptions->find("jointError")) {
      result.jointError = jointError->number({0, radians(20), "rad"});
    }
  }
  if (const auto boards = all.find("boards")) {
    for (const JsonPlace& board : boards->elements()) {
      result.boards[board.at("id").text()] = readFloorPlacement(board.at("placement"));
    }
  }
  for (const JsonPlace& pose : all.at("poses").elements()) {
    result.poses.push_back(poseFrom(pose, robot));
  }
  if (result.poses.empty()) {
    all.at("poses").refuse("at least one pose", "none");
  }
  return result;
}

} // namespace naocal
