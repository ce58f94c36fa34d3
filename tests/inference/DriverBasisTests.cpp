#include "inference/DriverBasis.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace naocal {

TEST_CASE("a driver that differs by a sum's rounding only has not changed") {
  // Proves it for adjacent doubles, as two means of equal values may be: a curve over them has zero width, and its
  // columns are not finite.
  const double angle = 0.3, next = std::nextafter(angle, 1);
  CHECK_FALSE(polynomialBasis({angle, next}, 4).basisAt(angle).allFinite());
  CHECK(distinctValues({next, angle, angle}) == std::set<double>{angle});
  CHECK(distinctValues({0.5, angle, next}) == std::set<double>{angle, 0.5});
}

TEST_CASE("moments lie in the widest gap of each run of gaps between times") {
  CHECK(gapsBetween({}).empty());
  CHECK(gapsBetween({3}).empty());
  CHECK(midpointsOf({}, 4).empty());
  const std::vector<TimeGap> gaps = gapsBetween({0, 1, 3, 4, 8});
  CHECK(gaps == std::vector<TimeGap>{{0, 1}, {1, 3}, {3, 4}, {4, 8}});
  CHECK(midpointsOf(gaps, 9) == std::vector<double>{0.5, 2, 3.5, 6});
  CHECK(midpointsOf(gaps, 2) == std::vector<double>{2, 6});
}

} // namespace naocal
