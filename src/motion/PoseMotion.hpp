#pragma once

#include "motion/JointOffsets.hpp"

#include <vector>

namespace naocal {

/// A smooth way through points in joint space: straight lines between them, at rest at each of them. On a line every
/// joint follows s(t) = 10 t^3 - 15 t^4 + 6 t^5 (least jerk), and the slowest joint at its allowed speed sets the time.
class PoseMotion {
public:
  /// `speed`: share of the joints' largest speeds, 0..1. Hands move within half a second.
  PoseMotion(const CompensatedAngles& start, std::vector<CompensatedAngles> points, const JointLimits& limits,
             double speed);

  double duration() const { return ends_.empty() ? 0 : ends_.back(); } // [s]

  /// Where it is after a time [s]; the last point from its end on.
  CompensatedAngles at(double time) const;

  /// How many of the points were passed by then.
  std::size_t passedPoints(double time) const;

private:
  std::vector<CompensatedAngles> points_; // the start first
  std::vector<double> ends_;              // when each line ends [s]
};

} // namespace naocal
