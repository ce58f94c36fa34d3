#pragma once

#include "poses/candidates/SupportLegs.hpp"
#include "poses/candidates/Transitions.hpp"

#include <map>
#include <random>

namespace naocal {

/// Ways of a robot on one foot, all from standing upright on it, so that poses can be taken in any order: 97 of 100
/// robots with joint errors stand all along, and no part touches another.
class SingleSupportPlanner {
public:
  /// `stand`: on both feet [rad]; `jointError`: as of Stability [rad].
  SingleSupportPlanner(const Robot& robot, SupportFoot foot, const Eigen::VectorXd& stand, double jointError);

  /// From the stand onto the foot (planOntoOneFoot).
  const std::vector<Eigen::VectorXd>& pathOnto() const { return onto_; }

  using Way = std::vector<Eigen::VectorXd>; // angles to pass through, the last ones where it leads [rad]
  struct Approach {
    Eigen::VectorXd side; // per joint: which way it turns into the pose, -1 or +1; 0: one that is not calibrated
    Way way;              // from standing upright to where the approach begins
  };
  /// Into a pose from `distance` beside it [rad], from where one can go on as far beyond it: each joint from the side
  /// that is wanted (-1 or +1; 0: drawn at random). Absent where no safe way was found.
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

/// Whether poses on one foot can be reached from standing upright on it, each joint from the side that is wanted, as
/// robots reach them (SingleSupportPlanner). Of poses on both feet nothing is asked.
class ReachabilityCheck {
public:
  /// `jointError`: as of Stability [rad].
  ReachabilityCheck(const Robot& robot, double jointError) : robot_{robot}, jointError_{jointError} {}

  bool operator()(const ProposedPose& pose);

private:
  const Robot& robot_;
  double jointError_;
  std::map<SupportFoot, SingleSupportPlanner> ways_;
};

} // namespace naocal
