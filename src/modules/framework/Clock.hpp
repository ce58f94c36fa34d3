#pragma once

#include <chrono>

namespace naocal {

/// The one clock of the robot's process: it never jumps. Stamps of other clocks are converted (ClockOffset).
using Clock = std::chrono::steady_clock;
using TimePoint = Clock::time_point;
using Duration = Clock::duration;

/// A duration in seconds.
inline double seconds(Duration duration) {
  return std::chrono::duration<double>{duration}.count();
}

/// The duration of so many seconds, to the nanosecond.
inline Duration fromSeconds(double value) {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>{value});
}

} // namespace naocal
