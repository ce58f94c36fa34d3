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

} // namespace naocal
