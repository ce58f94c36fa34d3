#include "math/Statistics.hpp"
#include "math/StudentMixture.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace naocal {

TEST_CASE("a mixture of one part has the quantiles of its Student's t") {
  // Proves the scale's meaning, and that many degrees of freedom are normal.
  const StudentMixture many{{{1, 3, 0.5}}, 1e6};
  for (const double freedom : {2.0, 5.0, 8.0, 12.0, 200.0}) {
    const StudentMixture one{{{1, 3, 0.5}}, freedom};
    for (const double probability : {0.00025, 0.025, 0.5, 0.975, 0.99975}) {
      CHECK(one.quantile(probability) == Approx(3 + 0.5 * studentQuantile(probability, freedom)).epsilon(1e-4));
      CHECK(one.below(3 + 0.5 * studentQuantile(probability, freedom)) == Approx(probability).epsilon(1e-3));
    }
  }
  CHECK(many.interval(0.95)[1] == Approx(3 + 0.5 * 1.959964).epsilon(1e-5));
  CHECK(many.interval(0.9995)[0] == Approx(3 - 0.5 * 3.480756).epsilon(1e-5));
}

TEST_CASE("a mixture's quantile has its probability below it, near and far parts alike") {
  // Proves the inverse, with a shoulder of 0.2 % beside a narrow rest, and with equal parts merged.
  std::vector<StudentMixture::Part> parts;
  for (int i = 0; i < 50; ++i) {
    parts.push_back({0.998 / 50, 1e-6 * i, 0.01});
  }
  parts.push_back({0.0019, 0.2, 0.01});
  parts.push_back({0.0001, 9, 0.02});
  for (const double freedom : {6.0, 40.0, 1e6}) {
    const StudentMixture mixture{parts, freedom};
    for (const double probability : {0.00025, 0.025, 0.5, 0.975, 0.99975}) {
      CHECK(mixture.below(mixture.quantile(probability)) == Approx(probability).epsilon(1e-4));
    }
    CHECK(mixture.quantile(0.99975) > 0.18); // the shoulder, not 3.5 sigma of the narrow part
    CHECK(mixture.quantile(0.975) < 0.05);
  }
}

} // namespace naocal
