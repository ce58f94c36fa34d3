#include "Moment.hpp"
#include "framework/core/Clock.hpp"

#include <catch2/catch.hpp>
#include <random>

namespace naocal {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

constexpr ClockOffset::Wall epoch = std::chrono::seconds{1700000000};

/// Wall clock that is `ahead` of Clock plus the epoch.
ClockOffset::Wall wallAt(TimePoint time, Duration ahead = {}) {
  return epoch + time.time_since_epoch() + ahead;
}

void sample(ClockOffset& clock, TimePoint time, Duration ahead = {}, Duration bracket = microseconds{1}) {
  clock.sample(time, wallAt(time, ahead) + bracket / 2, time + bracket);
}

double errorOf(const ClockOffset& clock, TimePoint taken, TimePoint now, Duration ahead = {}) {
  const auto converted = clock.convert(wallAt(taken, ahead), now);
  REQUIRE(converted);
  return std::abs(toSeconds(*converted - taken));
}

} // namespace

TEST_CASE("a wall clock's stamp becomes the time at which it was taken") {
  // Proves the conversion for steady clocks with some interrupted readings: the narrowest readings are used.
  std::mt19937 random{1};
  ClockOffset clock;
  CHECK_FALSE(clock.convert(wallAt(at(1)), at(1)));
  for (int i = 0; i < 100; ++i) {
    const bool interrupted = i % 3 == 0;
    const auto bracket = interrupted ? microseconds{1500} : microseconds{1};
    const TimePoint time = at(10 + 0.033 * i);
    // The wall clock is read at a random time within the bracket.
    const auto within = Duration{std::uniform_int_distribution<Duration::rep>{0, Duration{bracket}.count()}(random)};
    clock.sample(time, wallAt(time + within), time + bracket);
    if (i > 0) {
      CHECK(errorOf(clock, time - milliseconds{40}, time + bracket) < 20e-6);
    }
  }
}

TEST_CASE("a frame exposed before the wall clock was set is placed right after it") {
  // Proves it for jumps of an hour in both directions: frames on both sides of the jump.
  for (const Duration jump : {Duration{std::chrono::hours{1}}, Duration{-std::chrono::hours{1}}}) {
    ClockOffset clock;
    for (int i = 0; i <= 30; ++i) {
      sample(clock, at(1 + 0.033 * i));
    }
    const TimePoint before = at(1.98);
    sample(clock, at(2.02), jump);
    CHECK(errorOf(clock, before, at(2.025)) < 1e-6);
    CHECK(errorOf(clock, at(2.021), at(2.025), jump) < 1e-6);
  }
}

TEST_CASE("a wall clock that is slewed is followed") {
  // Proves that a drift of 500 ppm, the maximum of time services, costs less than 0.1 ms.
  ClockOffset clock;
  for (int i = 0; i < 3000; ++i) {
    const TimePoint time = at(1 + 0.033 * i);
    const auto ahead = fromSeconds(500e-6 * 0.033 * i);
    sample(clock, time, ahead);
    REQUIRE(errorOf(clock, time, time + milliseconds{1}, ahead) < 100e-6);
  }
}

TEST_CASE("a stamp from the future or from long ago is refused") {
  // Proves that implausible stamps give no time.
  ClockOffset clock;
  sample(clock, at(10));
  sample(clock, at(11));
  CHECK_FALSE(clock.convert(wallAt(at(11.5)), at(11.1)));
  CHECK_FALSE(clock.convert(wallAt(at(9)), at(11.1)));
  CHECK_FALSE(clock.convert(ClockOffset::Wall{0}, at(11.1)));
}

TEST_CASE("this computer's wall clock is read") {
  // Proves that the real clocks are used: a stamp taken between two times is converted to between them, to 5 ms.
  ClockOffset clock;
  for (int i = 0; i < 100; ++i) { // the narrowest reading is used: this thread may be preempted between two clocks
    clock.sampleNow();
  }
  const TimePoint before = Clock::now();
  const auto stamp = std::chrono::system_clock::now().time_since_epoch();
  const TimePoint after = Clock::now();
  const auto converted = clock.convert(std::chrono::duration_cast<ClockOffset::Wall>(stamp), after);
  REQUIRE(converted);
  CHECK(*converted >= before - milliseconds{5});
  CHECK(*converted <= after + milliseconds{5});
}

} // namespace naocal
