#pragma once

#include <vector>

namespace blind {

/// P value of Kolmogorov and Smirnov's test that numbers were drawn uniformly from 0 to 1, by the limit distribution
/// with Stephens' correction for few numbers: lambda = (sqrt n + 0.12 + 0.11 / sqrt n) D (JRSS B 32, 1970). Of less
/// than five numbers it says nothing: 1.
double uniformityP(std::vector<double> numbers);

/// The middle one of them, 0 of none.
double median(std::vector<double> numbers);

} // namespace blind
