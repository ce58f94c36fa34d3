#include "scenes/ScenePoses.hpp"

#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/Polygon.hpp"
#include "robot/Gravity.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace naocal {

namespace {

constexpr double nearRest = 0.6;    // from the rest angle, of a robot on its sole [rad]
constexpr double endless = 0.5;     // of a slide without limits, both ways [m]
constexpr double widest = 5;        // of a turn, both ways: sets hold less than a full one, offset included [rad]
constexpr double solePart = 0.5;    // of the sole over which the centre of mass is brought
constexpr double soleMargin = 0.01; // of the centre of mass inside the sole [m]
constexpr double soleRadius = 0.02; // of a sole without an outline [m]

const Sole* standingSole(const Robot& robot, const RobotScene& scene) {
  const Stance& stance = scene.set.stances.front();
  if (stance.supportLinks.size() > 1) {
    throw InputError{
        fmt::format("supportLinks: expected one link, found {}: poses on several feet are neither drawn nor "
                    "proposed",
                    stance.supportLinks.size())};
  }
  if (!stance.supportLinks.empty()) {
    return robot.findSole(stance.supportLinks.front());
  }
  if (!scene.set.urdf.empty() || stance.supportFoot == SupportFoot::none) {
    return nullptr;
  }
  return robot.findSole(supportFootWords[static_cast<std::size_t>(stance.supportFoot)]);
}

} // namespace

ScenePoses::ScenePoses(const Robot& robot, const RobotScene& scene, std::uint64_t seed)
    : robot_{robot}, scene_{scene}, sole_{standingSole(robot, scene)}, collision_{robot}, chance_{seed, "scene poses"} {
  hasMasses_ = std::any_of(robot.links.begin(), robot.links.end(), [](const Link& link) { return link.mass > 0; });
  if (sole_) {
    leg_ = ancestorJoints(robot, sole_->link);
    std::erase_if(leg_, [&](std::size_t joint) { return robot.joints[joint].motor != joint; });
  }
}

AngleRange ScenePoses::rangeOf(std::size_t joint) const {
  const Joint& drawn = robot_.joints[joint];
  const double most = drawn.isPrismatic ? endless : std::numbers::pi;
  AngleRange range{std::isfinite(drawn.limits.lower) ? drawn.limits.lower : -most,
                   std::isfinite(drawn.limits.upper) ? drawn.limits.upper : most};
  if (!drawn.isPrismatic) {
    range = {std::clamp(range.lower, -widest, widest), std::clamp(range.upper, -widest, widest)};
  }
  const auto given = scene_.ranges.find(drawn.name);
  if (given != scene_.ranges.end()) {
    return {std::clamp(given->second.lower, range.lower, range.upper),
            std::clamp(given->second.upper, range.lower, range.upper)};
  }
  if (sole_) {
    const double rest = std::clamp(drawn.restAngle, range.lower, range.upper);
    range = {std::max(range.lower, rest - nearRest), std::min(range.upper, rest + nearRest)};
  }
  return range;
}

void ScenePoses::followMotors(Eigen::VectorXd& angles) const {
  for (std::size_t joint = 0; joint < robot_.joints.size(); ++joint) {
    const Joint& drawn = robot_.joints[joint];
    if (drawn.motor != joint) {
      angles[eigenIndex(joint)] = drawn.ratio * angles[eigenIndex(drawn.motor)] + drawn.shift;
    }
  }
}

bool ScenePoses::isFree(const Eigen::VectorXd& angles) const {
  return isWithinLimits(angles) && !collision_.collides(forwardKinematics(robot_, angles));
}

bool ScenePoses::isWithinLimits(const Eigen::VectorXd& angles) const {
  for (std::size_t joint = 0; joint < robot_.joints.size(); ++joint) {
    const AngleRange limits = jointLimitsAt(robot_, joint, angles);
    const bool isDriven = robot_.joints[joint].motor != joint; // its motor's limits hold
    if (!isDriven && (angles[eigenIndex(joint)] < limits.lower || angles[eigenIndex(joint)] > limits.upper)) {
      return false;
    }
  }
  return true;
}

/// Brings the centre of mass over a random point of the sole: Gauss-Newton on the leg's joints with the minimum-norm
/// step. Returns whether it is well inside the sole.
bool ScenePoses::balance(ModelState& modelState) {
  const auto& outline = sole_->outline;
  Eigen::Vector2d target{chance_.uniformWithin(soleRadius), chance_.uniformWithin(soleRadius)};
  if (!outline.empty()) {
    const Eigen::Vector2d corner = outline[chance_.uniformBelow(outline.size())], middle = vertexMean(outline);
    target = middle + solePart * std::abs(chance_.uniformWithin(1)) * (corner - middle);
  }
  Eigen::Vector2d centre = target;
  constexpr int rounds = 6; // converges to 1 mm
  for (int round = 0; round <= rounds; ++round) {
    followMotors(modelState.values);
    const LinkPoses torsoFromLink = forwardKinematics(robot_, modelState);
    const GravityLoad load =
        gravityLoad(robot_, modelState, torsoFromLink, sole_->link, torsoFromLink[sole_->link].rotation.col(2));
    centre = load.com.head<2>();
    if (round == rounds) {
      break;
    }
    Eigen::Matrix2Xd byLeg(2, eigenIndex(leg_.size()));
    for (std::size_t i = 0; i < leg_.size(); ++i) {
      byLeg.col(eigenIndex(i)) = load.comByAngle.col(eigenIndex(leg_[i])).head<2>();
    }
    const Eigen::Matrix2d square = byLeg * byLeg.transpose() + 1e-6 * Eigen::Matrix2d::Identity();
    const Eigen::VectorXd turn = byLeg.transpose() * (square.inverse() * (target - centre));
    for (std::size_t i = 0; i < leg_.size(); ++i) {
      modelState.angle(leg_[i]) += turn[eigenIndex(i)];
    }
  }
  return outline.empty() ? centre.norm() < 2 * soleRadius : insideDepth(outline, centre) >= soleMargin;
}

/// Whether all links but the sole are above the floor, and other soles entirely so.
bool ScenePoses::isAboveFloor(const LinkPoses& torsoFromLink) const {
  constexpr double clearance = 0.005; // [m]
  const RigidTransform soleFromTorso = torsoFromLink[sole_->link].inverse();
  for (std::size_t link = 0; link < robot_.links.size(); ++link) {
    if (link != sole_->link && (soleFromTorso * torsoFromLink[link].translation).z() < 0) {
      return false;
    }
  }
  for (const Sole& other : robot_.soles) {
    for (const Eigen::Vector2d& corner : other.outline) {
      const Eigen::Vector3d point{corner.x(), corner.y(), 0};
      if (&other != sole_ && (soleFromTorso * (torsoFromLink[other.link] * point)).z() < clearance) {
        return false;
      }
    }
  }
  return true;
}

std::optional<Eigen::VectorXd> ScenePoses::draw() {
  ModelState modelState = nominalState(robot_, StateLayout{robot_.joints.size(), robot_.lengths.size(), 0});
  for (std::size_t joint = 0; joint < robot_.joints.size(); ++joint) {
    const AngleRange range = rangeOf(joint);
    const double half = (range.upper - range.lower) / 2;
    modelState.angle(joint) = range.lower + half + chance_.uniformWithin(half);
  }
  followMotors(modelState.values);
  ++counts_.generated;
  const bool isBalanced = !sole_ || !hasMasses_ || balance(modelState);
  const Eigen::VectorXd angles = modelState.values.head(eigenIndex(robot_.joints.size()));
  if (!isWithinLimits(angles)) {
    return std::nullopt;
  }
  ++counts_.reachable;
  const LinkPoses torsoFromLink = forwardKinematics(robot_, modelState);
  if (collision_.collides(torsoFromLink)) {
    return std::nullopt;
  }
  ++counts_.collisionFree;
  if (!isBalanced || (sole_ && !isAboveFloor(torsoFromLink))) {
    return std::nullopt;
  }
  ++counts_.stable;
  return angles;
}

} // namespace naocal
