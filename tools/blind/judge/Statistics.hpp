#pragma once

#include <cstddef>
#include <vector>

namespace blind {

/// Minimum sample size of the test.
constexpr std::size_t fewestForUniformity = 5;

/// P value of the Kolmogorov-Smirnov test that numbers are uniform in [0, 1], by the limit distribution with Stephens'
/// correction for small samples: lambda = (sqrt n + 0.12 + 0.11 / sqrt n) D (JRSS B 32, 1970). 1 for fewer than
/// `fewestForUniformity` numbers.
double uniformityP(std::vector<double> numbers);

/// The median; 0 for an empty list.
double median(std::vector<double> numbers);

} // namespace blind
