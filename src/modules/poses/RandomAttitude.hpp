#pragma once

#include "poses/PoseChecks.hpp"
#include "poses/StandingLegs.hpp"

#include <memory>
#include <optional>
#include <random>
#include <vector>

namespace naocal {

/// How a robot stands.
struct SievedPose {
  Belief belief;
  std::vector<double> point; // where in the ranges it was drawn from, one number in [0, 1] per range
  double standing = 0;       // share of robots with joint errors that stand so
  Eigen::VectorXd approach;  // per joint as in ProposedPose; empty: any
};

/// Draws attitudes of a standing robot from the ranges of PoseOptions, and sieves them.
class RandomAttitude {
public:
  /// `first`: where in the sequence of attitudes to begin.
  RandomAttitude(const Robot& robot, const Scene& scene, const PoseOptions& options, std::size_t first = 0);

  /// One attempt; absent when anything is wrong with it, which `sieve` counts.
  std::optional<SievedPose> draw(Sieve& sieve);

  /// The attitude at a point of the ranges, with no other glance than that.
  std::optional<SievedPose> at(const std::vector<double>& point, Sieve& sieve);

  /// The robot at a point of the ranges, whether or not it stands there; absent where its legs do not reach it.
  std::optional<Belief> reached(const std::vector<double>& point);

private:
  std::optional<SievedPose> attempt(int glances, Sieve& sieve);
  /// Head: as drawn, else anywhere, until a board is in sight of the robot, which must remain stable.
  bool lookAround(SievedPose& attitude, int glances);
  void turnHead(Belief& belief, const DrawnNumber& draw) const;

  double from(const Interval& interval); // by the next number of the point

  const Robot& robot_;
  const Scene& scene_;
  PoseChecks checks_;
  StandingLegs legs_;
  std::vector<std::size_t> head_; // joints between the root and the cameras
  Belief hanging_;                // all joints at rest
  std::unique_ptr<UnitPoints> points_;
  std::vector<double> point_; // one number per range, the head's at the end
  std::size_t used_ = 0;      // of it
  std::mt19937_64 random_;    // robots with errors, and further glances
};

} // namespace naocal
