#pragma once

#include "motion/JointOffsets.hpp"

#include <vector>

namespace naocal {

/// Smooth motion through points in joint space: straight segments, at rest at each point. On a segment every joint
/// follows s(t) = 10 t^3 - 15 t^4 + 6 t^5 (minimum jerk); the slowest joint at its allowed speed determines the
/// duration.
class PoseMotion {
public:
  /// `speed`: fraction of the joints' maximum speeds, (0, 1]. A hand moves through its whole range in 0.5 s.
  PoseMotion(const CompensatedAngles& start, std::vector<CompensatedAngles> points, const JointLimits& limits,
             double speed);

  double duration() const { return ends_.empty() ? 0 : ends_.back(); } // [s]

  /// The angles at a time [s] since the start; the last point after the end.
  CompensatedAngles at(double time) const;

  /// Number of points passed at a time [s].
  std::size_t passedPoints(double time) const;

private:
  std::vector<CompensatedAngles> points_; // starting point first
  std::vector<double> ends_;              // end time of each segment [s]
};

} // namespace naocal
