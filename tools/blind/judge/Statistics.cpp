#include "judge/Statistics.hpp"

#include <algorithm>
#include <cmath>

namespace blind {

double uniformityP(std::vector<double> numbers) {
  if (numbers.size() < fewestForUniformity) {
    return 1;
  }
  std::sort(numbers.begin(), numbers.end());
  const auto count = static_cast<double>(numbers.size());
  double distance = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double below = static_cast<double>(i) / count, upTo = static_cast<double>(i + 1) / count;
    distance = std::max({distance, numbers[i] - below, upTo - numbers[i]});
  }
  const double root = std::sqrt(count), lambda = (root + 0.12 + 0.11 / root) * distance;
  constexpr double small = 0.3; // below it the series converges slowly, and its limit is 1
  if (lambda < small) {
    return 1;
  }
  double p = 0;
  for (int term = 1; term <= 50; ++term) {
    p += (term % 2 == 1 ? 2 : -2) * std::exp(-2.0 * term * term * lambda * lambda);
  }
  return std::clamp(p, 0.0, 1.0);
}

double median(std::vector<double> numbers) {
  if (numbers.empty()) {
    return 0;
  }
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  if (numbers.size() % 2 == 1) {
    return *middle;
  }
  return (*middle + *std::max_element(numbers.begin(), middle)) / 2;
}

} // namespace blind
