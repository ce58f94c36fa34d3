#pragma once

#include "poses/candidates/SupportLegs.hpp"
#include "poses/candidates/Transitions.hpp"

#include <map>
#include <random>

namespace naocal {

/// Plans ways of a robot on one foot, all starting upright on it, so that poses can be taken in any order. Along each
/// way at least 97 % of robots with joint errors stay balanced, without self-collision.
class SingleSupportPlanner {
public:
  /// `stand`: on both feet [rad]; `jointError`: as in BalanceRequirement [rad].
  SingleSupportPlanner(const Robot& robot, SupportFoot foot, const Eigen::VectorXd& stand, double jointError);

  /// The way from the stand onto the foot (planOntoOneFoot).
  const std::vector<Eigen::VectorXd>& pathOnto() const { return onto_; }

  using Way = std::vector<Eigen::VectorXd>; // waypoints, target last [rad]
  struct Approach {
    Eigen::VectorXd side; // per joint: direction of the final motion, -1 or +1; 0: joint that is not calibrated
    Way way;              // from upright to the start of the approach
  };
  /// Plans the approach to a pose from `distance` beside it [rad], with as much safe range beyond it: each joint from
  /// the `wanted` side (-1 or +1; 0: random). Absent if no safe way is found.
  std::optional<Approach> planApproach(const Eigen::VectorXd& angles, const Eigen::VectorXd& wanted, double distance,
                                       std::mt19937_64& random) const;

private:
  std::optional<Way> safeWay(const Eigen::VectorXd& to) const;

  const Robot& robot_;
  SupportFoot foot_;
  PoseOptions options_;
  TransitionCheck ways_;
  std::vector<Eigen::VectorXd> onto_;
};

/// Tests whether a pose on one foot can be reached from standing upright on it, each joint from the wanted side
/// (SingleSupportPlanner). Poses on both feet always pass.
class ReachabilityCheck {
public:
  /// `jointError`: as in BalanceRequirement [rad].
  ReachabilityCheck(const Robot& robot, double jointError) : robot_{robot}, jointError_{jointError} {}

  bool operator()(const ProposedPose& pose);

private:
  const Robot& robot_;
  double jointError_;
  std::map<SupportFoot, SingleSupportPlanner> ways_;
};

} // namespace naocal
