#include "world/Pictures.hpp"

#include <catch2/catch.hpp>

namespace blind {

TEST_CASE("a bent sheet keeps the length of its radii and bends as high as it is told") {
  // Proves that bending preserves lengths along a radius, and the height against the contract's h.
  BoardFlaws flaws;
  flaws.bow = 0.01;
  const Eigen::Vector3d middle = sheetPoint(flaws, 3.5, 2.5), corner = sheetPoint(flaws, 0, 0);
  CHECK(middle.z() - corner.z() == Approx(0.01).epsilon(1e-9));
  CHECK(corner.z() == Approx(0).margin(1e-12));
  double length = 0;
  Eigen::Vector3d before = middle;
  constexpr int pieces = 2000;
  for (int i = 1; i <= pieces; ++i) {
    const double share = static_cast<double>(i) / pieces;
    const Eigen::Vector3d point = sheetPoint(flaws, 3.5 * (1 - share), 2.5 * (1 - share));
    length += (point - before).norm();
    before = point;
  }
  CHECK(length == Approx(std::hypot(3.5, 2.5) * Sheet::square).epsilon(1e-7));
  CHECK(sheetPoint({}, 2, 3) == Eigen::Vector3d{0.16, -0.24, 0});
}

} // namespace blind
