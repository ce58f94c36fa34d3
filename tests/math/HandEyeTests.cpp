#include "math/HandEye.hpp"

#include <catch2/catch.hpp>
#include <random>

namespace naocal {
namespace {

RigidTransform randomPose(std::mt19937_64& random, double reach = 1) {
  std::uniform_real_distribution<double> uniform{-1, 1};
  const Eigen::Vector3d turn{uniform(random), uniform(random), uniform(random)};
  return {rotationAbout(3 * turn), reach * Eigen::Vector3d{uniform(random), uniform(random), uniform(random)}};
}

double difference(const RigidTransform& a, const RigidTransform& b) {
  return (a.rotation - b.rotation).norm() + (a.translation - b.translation).norm();
}

} // namespace

TEST_CASE("an eye beside a hand and a target on it are found from their poses") {
  // Proves the closed form on exact data at any attitudes, and that noise of a milliradian moves it by little.
  std::mt19937_64 random{3};
  for (int trial = 0; trial < 20; ++trial) {
    const RigidTransform worldFromEye = randomPose(random), handFromTarget = randomPose(random, 0.1);
    std::vector<RigidTransform> hands, targets, noisy;
    for (int i = 0; i < 10; ++i) {
      hands.push_back(randomPose(random));
      targets.push_back(worldFromEye.inverse() * hands.back() * handFromTarget);
      noisy.push_back(targets.back());
      noisy.back().rotation *= rotationAbout(1e-3 * randomPose(random).translation);
    }
    const HandEye exact = solveHandEye(hands, targets), near = solveHandEye(hands, noisy);
    CHECK(difference(exact.worldFromEye, worldFromEye) < 1e-9);
    CHECK(difference(exact.handFromTarget, handFromTarget) < 1e-9);
    CHECK(difference(near.worldFromEye, worldFromEye) < 5e-3);
  }
}

TEST_CASE("an eye beside a hand and points on it are found from the points' positions") {
  // Proves the linear solution on exact data for one and for three points.
  std::mt19937_64 random{4};
  for (const std::size_t count : {1, 3}) {
    const RigidTransform worldFromEye = randomPose(random, 3);
    std::vector<Eigen::Vector3d> points;
    std::vector<SeenPoint> seen;
    for (std::size_t point = 0; point < count; ++point) {
      points.push_back(randomPose(random, 0.2).translation);
      for (int i = 0; i < 12; ++i) {
        const RigidTransform hand = randomPose(random);
        seen.push_back({hand, point, worldFromEye.inverse() * (hand * points[point])});
      }
    }
    const PointRegistration found = registerPoints(seen, count);
    CHECK(difference(found.worldFromEye, worldFromEye) < 1e-9);
    for (std::size_t point = 0; point < count; ++point) {
      CHECK((found.inHand[point] - points[point]).norm() < 1e-9);
    }
  }
}

TEST_CASE("a point on a hand that turns about two axes that meet is found with the eye that sees it") {
  // Proves it where the point at which the axes meet would fit with any eye: a positioner before a tracker.
  const RigidTransform worldFromEye{rotationZ(2.1) * rotationY(-0.3) * rotationX(0.4), {1.5, -2, 0.7}};
  const Eigen::Vector3d point{0.08, -0.12, 0.15};
  std::vector<SeenPoint> seen;
  for (int i = 0; i < 30; ++i) {
    const RigidTransform hand{rotationZ(0.4 * i) * rotationX(std::sin(1.7 * i)), {0, 0, 0.5}};
    seen.push_back({hand, 0, worldFromEye.inverse() * (hand * point)});
  }
  const PointRegistration found = registerPoints(seen, 1);
  double most = 0;
  for (const SeenPoint& one : seen) {
    most = std::max(most, (found.worldFromEye * one.inEye - one.worldFromHand * found.inHand[0]).norm());
  }
  CHECK(most < 1e-3);
  CHECK((found.inHand[0] - point).norm() < 1e-2);
}

TEST_CASE("a rotation is the product of its turns about x, y and z") {
  // Proves the angles within a quarter turn about y.
  const Eigen::Vector3d turns{0.4, -1.2, 2.5};
  const Eigen::Matrix3d rotation = rotationX(turns.x()) * rotationY(turns.y()) * rotationZ(turns.z());
  CHECK((turnsAboutXyz(rotation) - turns).norm() < 1e-12);
}

} // namespace naocal
