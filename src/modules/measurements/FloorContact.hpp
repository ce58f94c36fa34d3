#pragma once

#include "math/RigidTransform.hpp"

namespace naocal {

/// How flat soles and floor are, where the robot stands on both feet.
struct FloorContact {
  static constexpr double height = 0.001; // of one sole over the other's floor [m]
  static constexpr double tilt = 0.005;   // [rad]
};

/// Height and tilt of the other sole over the floor, in units of FloorContact, per motion (omega, v) of the floor seen
/// from that sole; `normal` is the floor's there:
///
///   height = -n . t, d(height) = -n . v;  d(n) = omega x n
inline Eigen::Matrix<double, 3, 6> floorContactJacobian(const Eigen::Vector3d& normal) {
  Eigen::Matrix<double, 3, 6> result = Eigen::Matrix<double, 3, 6>::Zero();
  result.row(0).tail<3>() = -normal.transpose() / FloorContact::height;
  result.bottomLeftCorner<2, 3>() = -crossMatrix(normal).topRows<2>() / FloorContact::tilt;
  return result;
}

} // namespace naocal
