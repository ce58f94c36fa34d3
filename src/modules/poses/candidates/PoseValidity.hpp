#pragma once

#include "poses/candidates/PoseOptions.hpp"
#include "robot/SelfCollision.hpp"

#include <optional>
#include <random>
#include <span>

namespace naocal {

/// Safety tests of standing poses.
class PoseValidity {
public:
  PoseValidity(const Robot& robot, const PoseOptions& options);

  /// Whether joints are within limits, with PoseOptions::limitMargin.
  bool isWithinLimits(const ModelState& modelState, std::span<const std::size_t> joints) const;

  /// Whether parts touch or the feet overlap seen from above: a lifted foot would strike the other ankle.
  bool selfCollides(const LinkPoses& torsoFromLink) const;

  /// Fraction of robots with joint errors that stay balanced; absent if it is too small or the drawn robot lacks the
  /// required footing.
  std::optional<double> balancedFraction(const ModelState& modelState, const LinkPoses& torsoFromLink,
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
