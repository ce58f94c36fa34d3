#pragma once

#include "math/RigidTransform.hpp"

namespace naocal {

/// Tolerances of the floor contact when the robot stands on both feet, 1 sigma.
struct FloorContact {
  static constexpr double height = 0.001; // height of one sole over the floor of the other [m]
  static constexpr double tilt = 0.005;   // [rad]
};

/// Jacobian of the other sole's height and tilt over the floor, in units of FloorContact, with respect to the motion
/// (omega, v) of the floor seen from that sole. `normal`: the floor's normal there.
///
///   height = -n . t, d(height) = -n . v;  d(n) = omega x n
inline Eigen::Matrix<double, 3, 6> floorContactJacobian(const Eigen::Vector3d& normal) {
  Eigen::Matrix<double, 3, 6> result = Eigen::Matrix<double, 3, 6>::Zero();
  result.row(0).tail<3>() = -normal.transpose() / FloorContact::height;
  result.bottomLeftCorner<2, 3>() = -crossMatrix(normal).topRows<2>() / FloorContact::tilt;
  return result;
}

} // namespace naocal
