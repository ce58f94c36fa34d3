#pragma once

#include "judge/Tally.hpp"

namespace blind {

/// Collects figures; those without sets are left out.
class Figures {
public:
  void atLeast(std::string what, double percent, const Share& share);
  void atMost(std::string what, double percent, const Share& share);
  void between(std::string what, double low, double high, const Share& share); // percent
  void value(std::string what, std::string wanted, double value, std::size_t sets, bool met);
  void add(std::string what, std::string wanted, const Share& share, bool met);
  std::vector<Required> all() && { return std::move(figures_); }

private:
  std::vector<Required> figures_;
};

/// The cell of that target noncentrality; empty if there is none.
Cell cellAt(const Tally& tally, double size);

/// Detection against the best that any test can do, for noncentralities where it is less than certain.
void addPower(const Tally& tally, Figures& figures);

/// Intervals and bounds of offsets, with and without hidden effects.
void addOffsets(const Tally& tally, Figures& figures);

/// Whether solve's p-values on sound sets are uniform, by noise regime.
void addUniformity(const Tally& tally, Figures& figures);

/// Errors on poses that were never used, and sizes inside their intervals, pooled over all noncentralities.
struct PooledSizes {
  Share errorFell, nearFloor, covered;
};
PooledSizes poolSizes(const Tally& tally);

} // namespace blind
