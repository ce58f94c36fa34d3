#include "runs/OffsetJumps.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fmt/format.h>
#include <random>

namespace naocal {

namespace {

constexpr std::size_t jointCount = 22;

/// Degrees of freedom of the estimates of two calibrations, and the share of a joint's error that all joints have in
/// common.
struct Setting {
  double earlier, later, common;
};

/// Draws the estimates of a calibration of joints at zero: t-distributed, each with a standard deviation of its own.
class Draws {
public:
  explicit Draws(std::uint64_t seed) : random_{seed} {}

  std::vector<RunOffset> calibrate(double freedom, double common) {
    std::normal_distribution<double> normal;
    std::chi_squared_distribution<double> spread{freedom};
    std::uniform_real_distribution<double> size{0.0005, 0.005};
    std::vector<RunOffset> offsets;
    const double shared = normal(random_);
    for (std::size_t joint = 0; joint < jointCount; ++joint) {
      const double sigma = size(random_), error = std::sqrt(common) * shared + std::sqrt(1 - common) * normal(random_);
      const double scale = std::sqrt((freedom - 2) / spread(random_)); // a t distribution of variance one
      offsets.push_back({sigma * scale * error, sigma, freedom});
    }
    return offsets;
  }

private:
  std::mt19937_64 random_;
};

std::vector<OffsetChange> compareAll(const std::vector<RunOffset>& earlier, const std::vector<RunOffset>& later) {
  std::vector<OffsetChange> changes;
  for (std::size_t joint = 0; joint < earlier.size(); ++joint) {
    changes.push_back(compareOffsets(earlier[joint], later[joint]));
  }
  findJumps(changes);
  return changes;
}

bool anyJump(const std::vector<OffsetChange>& changes) {
  return std::any_of(changes.begin(), changes.end(), [](const OffsetChange& change) { return change.isJump; });
}

} // namespace

TEST_CASE("joints that did not move are seldom said to have jumped", "[slow]") {
  // Proves by Monte Carlo that the share of pairs of calibrations with any false jump is the promised one, for many and
  // few degrees of freedom, equal and unequal, and at most that for joints whose errors have much in common. Three
  // standard errors of the simulation are allowed.
  const auto [earlier, later, common] =
      GENERATE(Setting{1e6, 1e6, 0}, Setting{12, 12, 0}, Setting{6, 30, 0}, Setting{1e6, 1e6, 0.8}, Setting{8, 8, 0.8});
  constexpr int pairs = 10'000;
  Draws draws{7};
  int alarms = 0;
  for (int i = 0; i < pairs; ++i) {
    alarms += anyJump(compareAll(draws.calibrate(earlier, common), draws.calibrate(later, common))) ? 1 : 0;
  }
  const double rate = double(alarms) / pairs, error = std::sqrt(jumpFalseAlarms * (1 - jumpFalseAlarms) / pairs);
  INFO(fmt::format("{} and {} degrees of freedom, {} in common: {:.4f} of pairs", earlier, later, common, rate));
  CHECK(rate <= jumpFalseAlarms + 3 * error);
  CHECK((common > 0 || rate >= jumpFalseAlarms - 4 * error));
}

TEST_CASE("a joint that moved by more than its uncertainty explains has jumped") {
  // Proves that jumps of ten standard deviations of the difference are found in every pair, and in no other joint more
  // often than chance allows; two degrees at a sigma of 0.05 degrees are far beyond.
  Draws draws{8};
  int found = 0, others = 0;
  for (int i = 0; i < 500; ++i) {
    const std::vector<RunOffset> before = draws.calibrate(12, 0);
    std::vector<RunOffset> after = draws.calibrate(12, 0);
    after[3].value += 10 * std::hypot(before[3].sigma, after[3].sigma);
    const auto changes = compareAll(before, after);
    found += changes[3].isJump ? 1 : 0;
    for (std::size_t joint = 0; joint < jointCount; ++joint) {
      others += joint != 3 && changes[joint].isJump ? 1 : 0;
    }
  }
  CHECK(found >= 490);
  CHECK(others <= 15);
}

TEST_CASE("the chance of a change is that of the textbook for known variances and for equal samples") {
  // Pins the normal limit: |d| = 1.96 s gives 5 %; that few degrees of freedom make it larger; and that sign and order
  // do not matter.
  const RunOffset zero{0, 0.003, 1e6}, moved{1.959964 * 0.005, 0.004, 1e6};
  CHECK(compareOffsets(zero, moved).chance == Approx(0.05).epsilon(1e-3));
  CHECK(compareOffsets(moved, zero).chance == Approx(0.05).epsilon(1e-3));
  CHECK(compareOffsets(zero, moved).value == Approx(1.959964 * 0.005));
  CHECK(compareOffsets(zero, moved).sigma == Approx(0.005));
  const RunOffset few{0, 0.003, 5}, fewMoved{5 * 0.005, 0.004, 5};
  const OffsetChange change = compareOffsets(few, fewMoved);
  CHECK(change.freedom > 5);
  CHECK(change.freedom < 10);
  CHECK(change.chance > compareOffsets({0, 0.003, 1e6}, {5 * 0.005, 0.004, 1e6}).chance);
}

TEST_CASE("with more joints a change needs to be larger to be a jump") {
  // Pins Holm's procedure by hand: three changes of p = 0.001, 0.004 and 0.5 become 0.003, 0.008 and 0.5; of p = 0.004,
  // 0.006, 0.5 the first becomes 0.012 and hides the second.
  const auto adjust = [](std::vector<double> chances) {
    std::vector<OffsetChange> changes;
    for (const double chance : chances) {
      changes.push_back({.chance = chance});
    }
    findJumps(changes);
    return changes;
  };
  const auto changes = adjust({0.004, 0.5, 0.001});
  CHECK(changes[0].familyChance == Approx(0.008));
  CHECK(changes[1].familyChance == Approx(0.5));
  CHECK(changes[2].familyChance == Approx(0.003));
  CHECK(changes[0].isJump);
  CHECK_FALSE(changes[1].isJump);
  CHECK(changes[2].isJump);
  const auto none = adjust({0.006, 0.004, 0.5});
  CHECK_FALSE(anyJump(none));
  CHECK(none[0].familyChance == Approx(0.012));
  CHECK(adjust({}).empty());
}

} // namespace naocal
