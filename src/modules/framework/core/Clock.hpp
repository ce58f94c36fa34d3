#pragma once

#include <chrono>
#include <deque>
#include <optional>

namespace naocal {

/// The one clock of the robot's process: it never jumps. Stamps of other clocks are converted (ClockOffset).
using Clock = std::chrono::steady_clock;
using TimePoint = Clock::time_point;
using Duration = Clock::duration;

/// A duration in seconds.
inline double toSeconds(Duration duration) {
  return std::chrono::duration<double>{duration}.count();
}

/// The duration of so many seconds, to the nanosecond.
inline Duration fromSeconds(double value) {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>{value});
}

/// Converts stamps of a clock that may jump (the wall clock of a V5's camera driver) into Clock.
///
/// Both clocks are read together now and then (`sample`). While their difference stays within `jump` it is one stretch,
/// converted with the difference that was read with the narrowest bracket; a larger change starts a new stretch. A
/// stamp is converted with the stretch in which it was taken: stamp - offset must lie within that stretch's time. So a
/// frame exposed before the clock was set is still placed right when it arrives after that.
class ClockOffset {
public:
  using Wall = std::chrono::nanoseconds; // since the wall clock's epoch

  explicit ClockOffset(Duration jump = std::chrono::milliseconds{2}) : jump_{jump} {}

  /// Reads both clocks; `before` and `after` bracket the reading of the wall clock.
  void sample(TimePoint before, Wall wall, TimePoint after);

  /// Reads Clock and the system's wall clock now.
  void sampleNow();

  /// When a stamp was taken, seen at `now`; absent when no stretch fits: before the first sample, or in the future.
  std::optional<TimePoint> convert(Wall stamp, TimePoint now) const;

private:
  struct Stretch {
    TimePoint first, last; // of its samples
    Duration offset;       // wall - Clock
    Duration bracket;      // of the sample that `offset` comes from
  };

  Duration jump_;
  std::deque<Stretch> stretches_; // oldest first
};

} // namespace naocal
