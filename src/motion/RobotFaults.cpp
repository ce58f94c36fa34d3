#include "motion/RobotFaults.hpp"

#include "math/Angles.hpp"

#include <cmath>
#include <fmt/format.h>

namespace naocal {

std::string RobotFaults::find(const PlayedCycle& cycle) {
  const double gravity = cycle.state.accelerometer.norm();
  const bool isSound =
      gravity >= weakestGravity && gravity <= strongestGravity && cycle.state.torsoAngles.allFinite(); // false for NaN
  nonsense_ = isSound ? 0 : nonsense_ + cycle.step;
  if (nonsense_ > longestNonsense) {
    return "The inertial unit gives no true values, so that a fall would not be noticed.";
  }
  for (std::size_t joint = 0; joint < jointCount; ++joint) {
    const double deviation = cycle.measured[joint] - cycle.wanted[joint];
    const bool isFree = limits_.maxSpeed(joint) > 0 && jointNames[joint] != "RHipYawPitch"; // no hand; its own motor
    const bool follows = !isFree || std::abs(deviation) <= radians(largestDeviation);
    deviating_[joint] = follows ? 0 : deviating_[joint] + cycle.step;
    if (deviating_[joint] > longestDeviation) {
      return fmt::format("{} does not follow: it was sent to {:.0f} degrees and reads {:.0f}.", jointNames[joint],
                         degrees(cycle.wanted[joint]), degrees(cycle.measured[joint]));
    }
  }
  return "";
}

void RobotFaults::reset() {
  deviating_ = {};
  nonsense_ = 0;
}

} // namespace naocal
