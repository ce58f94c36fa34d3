#pragma once

#include "inference/ScoreProblem.hpp"
#include "measurements/Measurements.hpp"

#include <cstddef>
#include <vector>

namespace naocal {

/// Indices of the poses in chronological order.
std::vector<std::size_t> sortPosesByTime(const Measurements& measurements);

/// Predictive test of a group of columns: how well the first four fifths of the poses predict the last fifth. A true
/// drift must pass; a straight line fitted to a step lowers the error of interpolated poses, but not of future ones.
struct Prequential {
  double gain = 0; // 2 [ln B(all poses) - ln B(the first four fifths)]: twice the log score of predicting the last
                   // block (Dawid, JRSS A 147 (1984) 278)
  double tail = 1; // probability of a misfit at least as large in the last block, if it resembles the earlier ones

  /// True if `gain` exceeds `threshold::predictsNext` and `tail` exceeds `threshold::predictsTail`.
  bool predicts() const;
};
/// `order`: as returned by `sortPosesByTime`. `group`: index of a named group.
Prequential scorePrequentially(const ScoreProblem& problem, const Noise& noise, const std::vector<std::size_t>& order,
                               std::size_t group);

} // namespace naocal
