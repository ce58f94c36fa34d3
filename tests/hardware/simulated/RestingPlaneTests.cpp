#include "hardware/simulated/RestingPlane.hpp"

#include "RobotV6.hpp"
#include "math/Angles.hpp"
#include "math/Polygon.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <random>

using namespace naocal;

namespace {

std::vector<Eigen::Vector3d> table() { // four feet, 0.5 m below the origin
  return {{0.1, 0.1, -0.5}, {0.1, -0.1, -0.5}, {-0.1, 0.1, -0.5}, {-0.1, -0.1, -0.5}};
}

const Eigen::Vector3d upright = Eigen::Vector3d::UnitZ();

} // namespace

// Proves the plane and height of a stable body.
TEST_CASE("a table stands on its feet") {
  const auto resting = findRestingPlane(table(), {0.05, -0.05, -0.1}, upright, 0.4);
  REQUIRE(resting);
  CHECK((resting->up - upright).norm() < 1e-12);
  CHECK(resting->height == Approx(-0.5));
}

// Proves that a body tilts onto the face below its centre of mass, by the geometric angle.
TEST_CASE("a table with one short leg tilts onto it where its weight is") {
  std::vector<Eigen::Vector3d> feet = table();
  feet[0].z() += 0.02;
  const auto towards = findRestingPlane(feet, {0.05, 0.05, -0.1}, upright, 0.4);
  REQUIRE(towards);
  CHECK(std::acos(towards->up.z()) == Approx(std::atan(0.02 / (0.1 * std::sqrt(2.0)))).epsilon(0.01));
  const auto away = findRestingPlane(feet, {-0.05, -0.05, -0.1}, upright, 0.4);
  REQUIRE(away);
  CHECK((away->up - upright).norm() < 1e-12);
}

// Proves the criterion for falling.
TEST_CASE("a body whose centre of mass is beside its feet, or that would have to tilt far, does not rest") {
  CHECK(!findRestingPlane(table(), {0.101, 0, -0.1}, upright, 0.4));
  CHECK(!findRestingPlane(table(), {0, -0.2, -0.1}, upright, 0.4));
  std::vector<Eigen::Vector3d> feet = table();
  feet[0].z() += 0.3;
  CHECK(!findRestingPlane(feet, {0.05, 0.05, -0.1}, upright, 0.4));
}

// Proves on random centres of mass that a sole supports exactly those above its outline, the criterion that poses/ uses
// for planned poses.
TEST_CASE("on one sole a robot stands where its centre of mass is over the outline") {
  const std::vector<Eigen::Vector2d>& outline = v6().findSole("left")->outline;
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector2d& corner : outline) {
    points.emplace_back(corner.x(), corner.y(), -0.3);
  }
  std::mt19937 random{1};
  std::uniform_real_distribution<double> place{-0.12, 0.12};
  int standing = 0;
  for (int draw = 0; draw < 1000; ++draw) {
    const Eigen::Vector3d centre{place(random), place(random), 0};
    const double depth = insideDepth(outline, centre.head<2>());
    if (std::abs(depth) > 1e-6) {
      CHECK(findRestingPlane(points, centre, upright, 0.4).has_value() == (depth > 0));
      standing += depth > 0;
    }
  }
  CHECK(standing > 100);
}

// Proves that soles which are almost in one plane, as of a robot whose two legs have just begun to move, do not throw
// it: faces that differ by less than the search resolves are one.
TEST_CASE("a robot on two soles that differ by hardly anything keeps standing") {
  std::mt19937 random{2};
  std::uniform_real_distribution<double> exponent{-9, -3}, sign{-1, 1};
  const auto tiny = [&] { return std::copysign(std::pow(10, exponent(random)), sign(random)); }; // [rad, m]
  int fallen = 0;
  for (int draw = 0; draw < 5000; ++draw) {
    std::vector<Eigen::Vector3d> points;
    for (const char* side : {"left", "right"}) {
      const double y = side[0] == 'l' ? 0.05 : -0.05;
      const Eigen::AngleAxisd pitch{tiny(), Eigen::Vector3d::UnitY()}, roll{tiny(), Eigen::Vector3d::UnitX()};
      for (const Eigen::Vector2d& corner : v6().findSole(side)->outline) {
        points.push_back(pitch * roll * Eigen::Vector3d{corner.x(), corner.y(), 0} + Eigen::Vector3d{0, y, -0.3});
      }
    }
    fallen += !findRestingPlane(points, {0.006, tiny(), -0.05}, upright, 0.4);
  }
  CHECK(fallen == 0);
}
