#pragma once

#include "math/Sampling.hpp"
#include "poses/candidates/PoseOptions.hpp"
#include "robot/SelfCollision.hpp"
#include "scenes/RobotScene.hpp"

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

namespace naocal {

/// Draws poses that a robot can take: joints within their limits, free of self-collision as far as its description has
/// shapes. A robot on its sole also balances on it, and nothing else is below the floor; its joints stay near their
/// rest angles unless the scene gives ranges, and those of the leg turn as little as brings the centre of mass over the
/// sole.
class ScenePoses {
public:
  /// Keeps references to both.
  ScenePoses(const Robot& robot, const RobotScene& scene, std::uint64_t seed);
  ScenePoses(Robot&&, const RobotScene&, std::uint64_t) = delete;

  /// One angle per joint [rad]; absent if the drawn pose cannot be taken.
  std::optional<Eigen::VectorXd> draw();

  /// Lets joints that mimic others follow their motors.
  void followMotors(Eigen::VectorXd& angles) const;

  /// The angles that poses are drawn from [rad].
  AngleRange rangeOf(std::size_t joint) const;

  /// Whether a robot whose base stands can take a pose: within the limits, its parts apart.
  bool isFree(const Eigen::VectorXd& angles) const;

  /// How many poses were drawn since the last call, and how many of them passed each test; `seeing` is not counted.
  PassCounts takeCounts() { return std::exchange(counts_, {}); }

  /// The sole that the robot stands on; absent if its base stands.
  const Sole* sole() const { return sole_; }

private:
  bool isWithinLimits(const Eigen::VectorXd& angles) const;
  bool balance(ModelState& modelState);
  bool isAboveFloor(const LinkPoses& torsoFromLink) const;

  const Robot& robot_;
  const RobotScene& scene_;
  const Sole* sole_ = nullptr;
  bool hasMasses_ = false;       // otherwise nothing is known of its balance
  std::vector<std::size_t> leg_; // motors between the root and the sole
  SelfCollision collision_;
  RandomStream chance_;
  PassCounts counts_;
};

} // namespace naocal
