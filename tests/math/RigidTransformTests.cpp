#include "math/Angles.hpp"
#include "math/RigidTransform.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <random>
#include <vector>

namespace naocal {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Rotation vectors of various lengths, including the switch to the series (0.01) and angles around pi.
std::vector<Vector3d> rotationVectors() {
  std::mt19937 random{1};
  std::normal_distribution<double> normal;
  std::vector<Vector3d> vectors{Vector3d::Zero()};
  for (const double length : {1e-12, 1e-6, 1e-3, 0.0099, 0.0101, 0.1, 1.0, 3.1, 3.2, 6.0}) {
    for (int i = 0; i < 5; ++i) {
      vectors.push_back(length * Vector3d{normal(random), normal(random), normal(random)}.normalized());
    }
  }
  return vectors;
}

double largestDifference(const Matrix3d& a, const Matrix3d& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

} // namespace

TEST_CASE("a rotation vector turns about its direction by its length") {
  // Compares rotationAbout with Eigen's AngleAxis.
  for (const Vector3d& v : rotationVectors()) {
    const Matrix3d expected = Eigen::AngleAxisd{v.norm(), v.stableNormalized()}.toRotationMatrix();
    INFO(v.transpose());
    CHECK(largestDifference(rotationAbout(v), expected) < 4e-15);
  }
}

TEST_CASE("rotations about the axes turn the next axis towards the one after it") {
  // Proves the sign: right-handed. The angle is proved by agreement with rotationAbout, tested above.
  CHECK((rotationX(radians(90)) * Vector3d::UnitY() - Vector3d::UnitZ()).norm() < 1e-15);
  CHECK((rotationY(radians(90)) * Vector3d::UnitZ() - Vector3d::UnitX()).norm() < 1e-15);
  CHECK((rotationZ(radians(90)) * Vector3d::UnitX() - Vector3d::UnitY()).norm() < 1e-15);
  CHECK(largestDifference(rotationX(0.3), rotationAbout({0.3, 0, 0})) < 1e-15);
  CHECK(largestDifference(rotationY(0.3), rotationAbout({0, 0.3, 0})) < 1e-15);
  CHECK(largestDifference(rotationZ(0.3), rotationAbout({0, 0, 0.3})) < 1e-15);
}

TEST_CASE("the left Jacobian says how a rotation turns when its vector changes") {
  // Compares with central differences, whose own error allows 1e-9.
  const double step = 1e-5;
  for (const Vector3d& v : rotationVectors()) {
    const Matrix3d jacobian = leftJacobian(v);
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d dv = step * Vector3d::Unit(axis);
      const Matrix3d turn = (rotationAbout(v + dv) - rotationAbout(v - dv)) / (2 * step) * rotationAbout(v).transpose();
      INFO(v.transpose() << ", axis " << axis);
      CHECK(largestDifference(turn, crossMatrix(jacobian.col(axis))) < 1e-9);
    }
  }
}

TEST_CASE("series and closed form of a rotation meet") {
  // Proves continuity at the switch: both sides differ only by the change in length.
  const Vector3d direction = Vector3d{1, -2, 0.5}.normalized();
  const double border = 0.01, step = 1e-12;
  const Vector3d below = (border - step) * direction, above = (border + step) * direction;
  CHECK(largestDifference(rotationAbout(below), rotationAbout(above)) < 3e-12);
  CHECK(largestDifference(leftJacobian(below), leftJacobian(above)) < 3e-12);
}

TEST_CASE("the inverse of a change of frame leads back, and changes follow each other from right to left") {
  // Proves composition and inverse by their action on points.
  const RigidTransform headFromCamera{rotationAbout({0.4, -0.7, 1.1}), {0.1, -0.2, 0.3}};
  const RigidTransform cameraFromBoard{rotationAbout({-1.2, 0.3, 0.2}), {1.5, 0.2, -0.4}};
  const Vector3d pointInBoard{0.3, -0.1, 0.7};
  const Vector3d pointInHead = (headFromCamera * cameraFromBoard) * pointInBoard;
  CHECK((pointInHead - headFromCamera * (cameraFromBoard * pointInBoard)).norm() < 1e-15);
  CHECK(((headFromCamera * cameraFromBoard).inverse() * pointInHead - pointInBoard).norm() < 1e-15);
  CHECK((RigidTransform{} * pointInBoard - pointInBoard).norm() == 0);
}

TEST_CASE("an angle is the same direction a turn further") {
  // Proves it for several turns in both directions, and for results within (-pi, pi).
  for (const double angle : {-3.0, -0.5, 0.0, 1.0, 3.1}) {
    for (const int turns : {-3, -1, 0, 2}) {
      CHECK(wrapAngle(angle + turns * radians(360)) == Approx(angle).margin(1e-14));
    }
  }
  CHECK(degrees(radians(12.5)) == Approx(12.5));
}

} // namespace naocal
