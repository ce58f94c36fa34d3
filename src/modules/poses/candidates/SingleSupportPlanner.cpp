#include "poses/candidates/SingleSupportPlanner.hpp"

#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <utility>

namespace naocal {

namespace {

PoseOptions onFoot(SupportFoot foot, double jointError) {
  PoseOptions options;
  options.supportFoot = foot;
  options.stability.jointError = jointError;
  return options;
}

/// Joints between a sole and a camera: legs and head.
bool isCalibrated(const std::string& joint) {
  return joint.starts_with("Head") || joint.find("Hip") != std::string::npos ||
         joint.find("Knee") != std::string::npos || joint.find("Ankle") != std::string::npos;
}

} // namespace

SingleSupportPlanner::SingleSupportPlanner(const Robot& robot, SupportFoot foot, const Eigen::VectorXd& stand,
                                           double jointError)
    : robot_{robot}, foot_{foot}, options_{onFoot(foot, jointError)}, ways_{robot, options_}, onto_{planOntoOneFoot(
                                                                                                  robot, foot, stand)} {
}

std::optional<SingleSupportPlanner::Way> SingleSupportPlanner::safeWay(const Eigen::VectorXd& to) const {
  for (const int parts : {1, 2, 4, 8}) {
    auto way = interpolateOnOneFoot(robot_, foot_, onto_.back(), to, parts);
    if (!way) {
      continue;
    }
    way->push_back(to);
    const Eigen::VectorXd* last = &onto_.back();
    const bool safe = std::all_of(way->begin(), way->end(), [&](const Eigen::VectorXd& point) {
      return ways_.duration(*std::exchange(last, &point), point).has_value();
    });
    if (safe) {
      return way;
    }
  }
  return std::nullopt;
}

std::optional<SingleSupportPlanner::Approach> SingleSupportPlanner::planApproach(const Eigen::VectorXd& angles,
                                                                                 const Eigen::VectorXd& wanted,
                                                                                 double distance,
                                                                                 std::mt19937_64& random) const {
  constexpr int tries = 16;
  Approach result{Eigen::VectorXd::Zero(angles.size()), {}};
  for (int attempt = 0; attempt < tries; ++attempt) {
    for (std::size_t joint = 0; joint < robot_.joints.size(); ++joint) {
      const double side = random() % 2 == 0 ? 1 : -1;
      result.side[eigenIndex(joint)] = !isCalibrated(robot_.joints[joint].name) ? 0
                                       : wanted[eigenIndex(joint)] != 0         ? wanted[eigenIndex(joint)]
                                                                                : side;
      if (const std::size_t motor = robot_.joints[joint].motor; motor != joint) {
        result.side[eigenIndex(joint)] = result.side[eigenIndex(motor)];
      }
    }
    const Eigen::VectorXd below = angles - distance * result.side, above = angles + distance * result.side;
    if (!ways_.duration(below, angles) || !ways_.duration(angles, above)) {
      continue;
    }
    if (auto way = safeWay(below)) {
      result.way = std::move(*way);
      return result;
    }
  }
  return std::nullopt;
}

bool ReachabilityCheck::operator()(const ProposedPose& pose) {
  constexpr double aside = radians(1); // distance of the approach, as in the robots' configuration
  const SupportFoot foot = pose.pose.supportFoot;
  if (foot != SupportFoot::left && foot != SupportFoot::right) {
    return true;
  }
  const auto ways = ways_.try_emplace(foot, robot_, foot, bentKneesStance(robot_), jointError_).first;
  std::mt19937_64 random{1};
  return ways->second.planApproach(pose.pose.angles, pose.approach, aside, random).has_value();
}

} // namespace naocal
