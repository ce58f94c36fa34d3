#pragma once

#include <chrono>
#include <deque>
#include <optional>

namespace naocal {

/// The monotonic clock of the robot's process. `ClockOffset` converts time stamps of other clocks.
using Clock = std::chrono::steady_clock;
using TimePoint = Clock::time_point;
using Duration = Clock::duration;

/// A duration in seconds.
inline double toSeconds(Duration duration) {
  return std::chrono::duration<double>{duration}.count();
}

/// The duration of `value` seconds; resolution 1 ns.
inline Duration fromSeconds(double value) {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>{value});
}

/// Converts stamps of a clock that may jump (the wall clock of a V5's camera driver) into Clock.
///
/// `sample` reads both clocks together from time to time. While the offset changes by less than `jump`, samples belong
/// to one stretch; its offset comes from the sample with the narrowest bracket. A larger change starts a new stretch. A
/// stamp is converted with the stretch in which it was taken: stamp - offset must lie within that stretch's time span.
/// A frame exposed before the wall clock was set is therefore still placed correctly when it arrives afterwards.
class ClockOffset {
public:
  using Wall = std::chrono::nanoseconds; // since the wall clock's epoch

  explicit ClockOffset(Duration jump = std::chrono::milliseconds{2}) : jump_{jump} {}

  /// Adds a sample; `before` and `after` bracket the reading of the wall clock.
  void sample(TimePoint before, Wall wall, TimePoint after);

  /// Reads Clock and the system's wall clock now.
  void sampleNow();

  /// The time of a stamp received at `now`; absent if no stretch fits: before the first sample, or in the future.
  std::optional<TimePoint> convert(Wall stamp, TimePoint now) const;

private:
  struct Stretch {
    TimePoint first, last; // of its samples
    Duration offset;       // wall - Clock
    Duration bracket;      // width of the reading that gave `offset`, widened with age
  };

  Duration jump_;
  std::deque<Stretch> stretches_; // oldest first
};

} // namespace naocal
