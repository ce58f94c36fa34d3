#include "math/RigidTransform.hpp"

#include "math/Angles.hpp"

#include <cmath>

namespace naocal {

Eigen::Matrix3d rotationX(double angle) {
  const auto [s, c] = SineCosine{angle};
  return Eigen::Matrix3d{{1, 0, 0}, {0, c, -s}, {0, s, c}};
}

Eigen::Matrix3d rotationY(double angle) {
  const auto [s, c] = SineCosine{angle};
  return Eigen::Matrix3d{{c, 0, s}, {0, 1, 0}, {-s, 0, c}};
}

Eigen::Matrix3d rotationZ(double angle) {
  const auto [s, c] = SineCosine{angle};
  return Eigen::Matrix3d{{c, -s, 0}, {s, c, 0}, {0, 0, 1}};
}

Eigen::Vector3d turnsAboutXyz(const Eigen::Matrix3d& rotation) {
  return {std::atan2(-rotation(1, 2), rotation(2, 2)),
          std::atan2(rotation(0, 2), std::hypot(rotation(0, 0), rotation(0, 1))),
          std::atan2(-rotation(0, 1), rotation(0, 0))};
}

Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v) {
  return (Eigen::Matrix3d{} << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0).finished();
}

namespace {

/// sin(t)/t, (1 - cos t)/t^2 and (t - sin t)/t^3; by series for small t, where the quotients lose digits.
struct RodriguesTerms {
  explicit RodriguesTerms(double squaredAngle) {
    if (squaredAngle < 1e-4) {
      const double s = squaredAngle;
      sine = 1 - s / 6 * (1 - s / 20 * (1 - s / 42));
      versine = 0.5 - s / 24 * (1 - s / 30 * (1 - s / 56));
      rest = 1.0 / 6 - s / 120 * (1 - s / 42 * (1 - s / 72));
      return;
    }
    const double angle = std::sqrt(squaredAngle);
    sine = std::sin(angle) / angle;
    versine = (1 - std::cos(angle)) / squaredAngle;
    rest = (1 - sine) / squaredAngle;
  }
  double sine, versine, rest;
};

} // namespace

Eigen::Matrix3d rotationAbout(const Eigen::Vector3d& v) {
  const RodriguesTerms terms{v.squaredNorm()};
  const Eigen::Vector3d w = terms.versine * v;
  const Eigen::Vector3d s = terms.sine * v;
  const double xy = w.x() * v.y(), xz = w.x() * v.z(), yz = w.y() * v.z();
  const double xx = w.x() * v.x(), yy = w.y() * v.y(), zz = w.z() * v.z();
  Eigen::Matrix3d rotation;
  rotation << 1 - yy - zz, xy - s.z(), xz + s.y(), xy + s.z(), 1 - xx - zz, yz - s.x(), xz - s.y(), yz + s.x(),
      1 - xx - yy;
  return rotation;
}

Eigen::Matrix3d leftJacobian(const Eigen::Vector3d& v) {
  const RodriguesTerms terms{v.squaredNorm()};
  return terms.sine * Eigen::Matrix3d::Identity() + terms.versine * crossMatrix(v) + terms.rest * v * v.transpose();
}

Eigen::Matrix3d opticalFromCamera() {
  return (Eigen::Matrix3d{} << 0, -1, 0, 0, 0, -1, 1, 0, 0).finished();
}

} // namespace naocal
