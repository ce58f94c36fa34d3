#pragma once

#include "inference/ScoreProblem.hpp"
#include "measurements/Measurements.hpp"

#include <cstddef>
#include <vector>

namespace naocal {

/// Poses in the order in which they were taken.
std::vector<std::size_t> sortPosesByTime(const Measurements& measurements);

/// How well a group of columns predicts the last fifth of the poses from those before. What drifts must: a line through
/// a step lowers the error of poses between others, but not of those to come.
struct Prequential {
  double gain = 0; // 2 [ln B(all poses) - ln B(the first four fifths)]: twice the log score of predicting the last
                   // block (Dawid, JRSS A 147 (1984) 278)
  double tail = 1; // chance that the last block is as far off, were it like those before

  bool predicts() const;
};
/// `order`: of the problem's poses, as in `sortPosesByTime`. `group`: one of the named ones.
Prequential scorePrequentially(const ScoreProblem& problem, const Noise& noise, const std::vector<std::size_t>& order,
                               std::size_t group);

} // namespace naocal
