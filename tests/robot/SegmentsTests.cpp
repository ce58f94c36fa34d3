#include "robot/SelfCollision.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

using namespace naocal;
using Eigen::Vector3d;

TEST_CASE("segments are as far apart as a fine search finds") {
  // Compares with brute force over 200 random pairs; also degenerate cases: points, parallel and touching segments.
  std::mt19937_64 random{1};
  std::uniform_real_distribution<double> number{-1, 1};
  const auto point = [&] {
    const double x = number(random), y = number(random), z = number(random);
    return Vector3d{x, y, z};
  };
  for (int i = 0; i < 200; ++i) {
    const Vector3d p = point(), q = point(), r = point(), s = point();
    constexpr int steps = 100;
    double least = 1e9;
    for (int a = 0; a <= steps; ++a) {
      const Vector3d here = p + (q - p) * a / steps;
      const double along = std::clamp((here - r).dot(s - r) / (s - r).squaredNorm(), 0.0, 1.0);
      least = std::min(least, (here - r - along * (s - r)).norm());
    }
    CHECK(segmentDistance(p, q, r, s) <= least + 1e-12);
    CHECK(segmentDistance(p, q, r, s) == Approx(least).margin(2e-3));
    CHECK(segmentDistance(p, q, r, s) == Approx(segmentDistance(r, s, q, p)).margin(1e-12));
  }
  const Vector3d origin = Vector3d::Zero(), x = Vector3d::UnitX(), y = Vector3d::UnitY();
  CHECK(segmentDistance(origin, origin, y, y) == Approx(1));
  CHECK(segmentDistance(origin, origin, y - x, y + x) == Approx(1));
  CHECK(segmentDistance(origin, x, y, y + x) == Approx(1));
  CHECK(segmentDistance(origin, x, 3 * x, 2 * x) == Approx(1));
  CHECK(segmentDistance(-x, x, -y, y) == Approx(0).margin(1e-15));
}
