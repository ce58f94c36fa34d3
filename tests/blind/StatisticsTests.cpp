#include "judge/Statistics.hpp"

#include <catch2/catch.hpp>

namespace blind {

TEST_CASE("the test of uniformity lets uniform numbers pass and others not, as often as it says") {
  // Compares the p-value with a published quantile (D = 0.1340 is the 5 % point for n = 100) and clear cases; also the
  // median. The rate of false alarms is not simulated.
  std::vector<double> even, shifted, same(20, 1.0);
  for (int i = 0; i < 100; ++i) {
    even.push_back((i + 0.5) / 100);
    shifted.push_back(std::min(1.0, std::max(0.0, (i + 0.5) / 100 + 0.129))); // D = 0.134
  }
  CHECK(uniformityP(even) > 0.999);
  CHECK(uniformityP(shifted) == Approx(0.05).margin(0.005));
  CHECK(uniformityP(same) < 1e-6);
  CHECK(uniformityP({0.9, 0.9}) == 1);
  CHECK(median({3, 1, 2}) == 2);
  CHECK(median({4, 1, 2, 3}) == 2.5);
}

} // namespace blind
