#include "runs/OffsetJumps.hpp"

#include "math/Statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace naocal {

namespace {

/// Relative variance of the variance behind a t distribution of this many degrees of freedom.
double relativeSpread(double freedom) {
  return 2 / std::max(freedom - 4, 1e-6);
}

} // namespace

OffsetChange compareOffsets(const RunOffset& earlier, const RunOffset& later) {
  const double first = earlier.sigma * earlier.sigma, second = later.sigma * later.sigma;
  const double variance = first + second;
  const double spread =
      (relativeSpread(earlier.freedom) * first * first + relativeSpread(later.freedom) * second * second) /
      (variance * variance);
  OffsetChange change{.value = later.value - earlier.value, .sigma = std::sqrt(variance)};
  change.freedom = std::min(4 + 2 / spread, 1e6);
  const double scale = change.sigma * std::sqrt((change.freedom - 2) / change.freedom);
  change.chance = 2 * studentBelow(-std::abs(change.value) / scale, change.freedom);
  return change;
}

void findJumps(std::vector<OffsetChange>& changes) {
  std::vector<std::size_t> order(changes.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return changes[a].chance < changes[b].chance; });
  double highest = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    OffsetChange& change = changes[order[k]];
    highest = std::max(highest, std::min(1.0, static_cast<double>(order.size() - k) * change.chance));
    change.familyChance = highest;
    change.isJump = highest <= jumpFalseAlarms;
  }
}

} // namespace naocal
