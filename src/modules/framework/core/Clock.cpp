#include "framework/core/Clock.hpp"

namespace naocal {
namespace {

constexpr std::size_t mostStretches = 8;
constexpr Duration oldestFrame = std::chrono::seconds{1};          // maximum age of a frame at delivery
constexpr Duration agingPerSecond = std::chrono::microseconds{20}; // growth of the bracket by quartz drift and slewing

} // namespace

void ClockOffset::sample(TimePoint before, Wall wall, TimePoint after) {
  const Duration bracket = after - before;
  const TimePoint middle = before + bracket / 2;
  const Duration offset = wall - middle.time_since_epoch();
  const bool jumped = stretches_.empty() || std::chrono::abs(offset - stretches_.back().offset) > jump_ + bracket / 2;
  if (jumped) {
    stretches_.push_back({middle, middle, offset, bracket});
    if (stretches_.size() > mostStretches) {
      stretches_.pop_front();
    }
    return;
  }
  Stretch& stretch = stretches_.back();
  const Duration aged = fromSeconds(toSeconds(middle - stretch.last) * toSeconds(agingPerSecond));
  stretch.last = middle;
  stretch.bracket += aged;
  if (bracket <= stretch.bracket) {
    stretch.offset = offset;
    stretch.bracket = bracket;
  }
}

void ClockOffset::sampleNow() {
  const TimePoint before = Clock::now();
  const auto wall = std::chrono::system_clock::now().time_since_epoch();
  sample(before, std::chrono::duration_cast<Wall>(wall), Clock::now());
}

std::optional<TimePoint> ClockOffset::convert(Wall stamp, TimePoint now) const {
  for (auto entry = stretches_.rbegin(); entry != stretches_.rend(); ++entry) {
    const Stretch& stretch = *entry;
    const TimePoint time{std::chrono::duration_cast<Duration>(stamp) - stretch.offset};
    const bool isNewest = &stretch == &stretches_.back();
    const TimePoint first = &stretch == &stretches_.front() ? stretch.first - oldestFrame : stretch.first;
    const TimePoint last = isNewest ? now : stretch.last;
    if (time >= first - jump_ && time <= last + jump_ && time >= now - oldestFrame) {
      return time;
    }
  }
  return std::nullopt;
}

} // namespace naocal
