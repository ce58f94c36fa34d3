#include "scenes/TouchPoses.hpp"

#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <set>

namespace naocal {

namespace {

constexpr double closeEnough = 1e-9; // to the place [m]

/// Motors that move a link against the base.
std::vector<std::size_t> motorsBetween(const Robot& robot, std::size_t link) {
  std::set<std::size_t> motors;
  for (const std::size_t chain : {link, robot.base}) {
    for (const std::size_t joint : ancestorJoints(robot, chain)) {
      motors.insert(robot.joints[joint].motor);
    }
  }
  return {motors.begin(), motors.end()};
}

} // namespace

TrueRobot::Pose TouchPoses::find(std::size_t touch, const TrueRobot::Pose& pose, const Eigen::VectorXd& before,
                                 const Eigen::Vector3d& offset) {
  constexpr std::size_t mostStarts = 300;
  nearest_ = std::numeric_limits<double>::infinity();
  for (std::size_t start = 0, draw = 0; start < mostStarts && draw < mostTries; ++draw) {
    const auto angles = robot_.poses().draw();
    if (!angles) {
      continue;
    }
    ++start;
    if (auto found = reach(touch, pose, *angles, &before, offset)) {
      return *found;
    }
  }
  const ContactReading& contact = robot_.touches()[touch].contacts.front();
  throw InputError{
      fmt::format("places: \"{}\": expected a place that marker \"{}\" can touch within the joints' "
                  "limits, its parts apart, found it {:.0f} mm away or in the robot from each of {} random "
                  "poses; place it nearer to the robot, or widen `ranges` of joints in the scene",
                  contact.place, contact.marker, 1e3 * nearest_, mostStarts)};
}

std::optional<TrueRobot::Pose> TouchPoses::findNear(std::size_t touch, const TrueRobot::Pose& pose,
                                                    const Eigen::Vector3d& offset) {
  return reach(touch, pose, last_, nullptr, offset);
}

/// Steps by J^T (J J^T + |miss| damping)^-1 miss, with J by differences, clamped to the ranges.
std::optional<TrueRobot::Pose> TouchPoses::reach(std::size_t touch, TrueRobot::Pose pose, Eigen::VectorXd angles,
                                                 const Eigen::VectorXd* before, const Eigen::Vector3d& offset) {
  constexpr double nudge = 1e-6, damping = 1e-3, longestStep = 0.5; // [rad], [1], [rad]
  constexpr int mostRounds = 60;
  const Robot& robot = robot_.robot();
  const std::vector<std::size_t> motors = motorsBetween(robot, robot_.linkOfTouch(touch));
  const auto miss = [&](const Eigen::VectorXd& at) {
    pose.recorded = robot_.recordedAt(at);
    if (before) {
      pose.approach = (pose.recorded - *before).cwiseSign();
    }
    return Eigen::Vector3d{robot_.missAt(touch, pose) - offset};
  };
  for (int round = 0; round < mostRounds; ++round) {
    const Eigen::Vector3d missed = miss(angles);
    nearest_ = std::min(nearest_, missed.norm());
    if (missed.norm() < closeEnough) {
      if (!robot_.poses().isFree(angles)) {
        return std::nullopt;
      }
      last_ = angles;
      return pose;
    }
    Eigen::Matrix3Xd slopes(3, eigenIndex(motors.size()));
    for (std::size_t i = 0; i < motors.size(); ++i) {
      Eigen::VectorXd nudged = angles;
      nudged[eigenIndex(motors[i])] += nudge;
      robot_.poses().followMotors(nudged);
      slopes.col(eigenIndex(i)) = (miss(nudged) - missed) / nudge;
    }
    Eigen::Matrix3d square = slopes * slopes.transpose();
    square.diagonal().array() += damping * missed.norm() + 1e-12;
    Eigen::VectorXd step = slopes.transpose() * square.ldlt().solve(missed);
    step *= std::min(1.0, longestStep / std::max(step.norm(), longestStep / 2));
    for (std::size_t i = 0; i < motors.size(); ++i) {
      const AngleRange range = robot_.poses().rangeOf(motors[i]);
      double& angle = angles[eigenIndex(motors[i])];
      angle = std::clamp(angle - step[eigenIndex(i)], range.lower, range.upper);
    }
    robot_.poses().followMotors(angles);
  }
  return std::nullopt;
}

} // namespace naocal
