#include "motion/PoseMotion.hpp"

#include <algorithm>
#include <cmath>

namespace naocal {
namespace {

constexpr double peakSpeed = 1.875; // peak of ds/dt, in units of the mean speed
constexpr double handSeconds = 0.5; // for the full range of a hand
constexpr double shortest = 0.1;    // [s]; minimum duration of a segment

double timeFor(const CompensatedAngles& from, const CompensatedAngles& to, const JointLimits& limits, double speed) {
  double time = shortest;
  for (std::size_t joint = 0; joint < jointCount; ++joint) {
    const double way = std::abs(to[joint] - from[joint]);
    const double fastest = limits.maxSpeed(joint);
    time = std::max(time, fastest > 0 ? peakSpeed * way / (speed * fastest) : way * handSeconds);
  }
  return time;
}

} // namespace

PoseMotion::PoseMotion(const CompensatedAngles& start, std::vector<CompensatedAngles> points, const JointLimits& limits,
                       double speed)
    : points_{std::move(points)} {
  points_.insert(points_.begin(), start);
  for (std::size_t i = 1; i < points_.size(); ++i) {
    ends_.push_back(duration() + timeFor(points_[i - 1], points_[i], limits, speed));
  }
}

std::size_t PoseMotion::passedPoints(double time) const {
  return static_cast<std::size_t>(std::upper_bound(ends_.begin(), ends_.end(), time) - ends_.begin());
}

CompensatedAngles PoseMotion::at(double time) const {
  const std::size_t line = passedPoints(time);
  if (line == ends_.size()) {
    return points_.back();
  }
  const double begin = line == 0 ? 0 : ends_[line - 1];
  const double t = std::max(0.0, (time - begin) / (ends_[line] - begin));
  return interpolate(points_[line], points_[line + 1], t * t * t * (10 - 15 * t + 6 * t * t));
}

} // namespace naocal
