#pragma once

#include "poses/candidates/PoseOptions.hpp"
#include "robot/SelfCollision.hpp"

#include <optional>
#include <random>
#include <span>

namespace naocal {

/// What makes a standing pose a safe one.
class PoseValidity {
public:
  PoseValidity(const Robot& robot, const PoseOptions& options);

  /// With the margin for unknown offsets.
  bool isWithinLimits(const ModelState& belief, std::span<const std::size_t> joints) const;

  /// Parts touch, or one foot is over the other: seen from above, a lifted foot would strike the other one's ankle.
  bool selfCollides(const LinkPoses& torsoFromLink) const;

  /// The share of robots with joint errors that stand so; absent where it is too small or the robot as drawn has not
  /// the wanted footing.
  std::optional<double> balancedFraction(const ModelState& belief, const LinkPoses& torsoFromLink,
                                         std::mt19937_64& random) const;

  const Sole& support() const { return support_; }
  const Sole& other() const { return other_; }

private:
  const Robot& robot_;
  const PoseOptions& options_;
  const Sole &support_, &other_;
  SelfCollision collision_;
};

} // namespace naocal
