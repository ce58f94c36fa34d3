#pragma once

#include <cstddef>
#include <vector>

namespace blind {

/// Of fewer numbers nothing is said.
constexpr std::size_t fewestForUniformity = 5;

/// P value of Kolmogorov and Smirnov's test that numbers were drawn uniformly from 0 to 1, by the limit distribution
/// with Stephens' correction for few numbers: lambda = (sqrt n + 0.12 + 0.11 / sqrt n) D (JRSS B 32, 1970). 1 of too
/// few numbers.
double uniformityP(std::vector<double> numbers);

/// The middle one of them, 0 of none.
double median(std::vector<double> numbers);

} // namespace blind
