#pragma once

#include <Eigen/Core>

namespace naocal {

/// Rotations written as three angles [rad] about x, y, z, in the order in which a dialect multiplies them. The angle of
/// the middle factor stays within 90 degrees.
///
///   Xyz: Rx(x) Ry(y) Rz(z)     naocal; HULKs 2019
///   Yxz: Ry(y) Rx(x) Rz(z)     B-Human, Nao Devils
///   Zyx: Rz(z) Ry(y) Rx(x)     HULKs since 2021 (nalgebra's from_euler_angles)
Eigen::Matrix3d rotationXyz(const Eigen::Vector3d& angles);
Eigen::Matrix3d rotationYxz(const Eigen::Vector3d& angles);
Eigen::Matrix3d rotationZyx(const Eigen::Vector3d& angles);
Eigen::Vector3d anglesXyz(const Eigen::Matrix3d& rotation);
Eigen::Vector3d anglesYxz(const Eigen::Matrix3d& rotation);
Eigen::Vector3d anglesZyx(const Eigen::Matrix3d& rotation);

} // namespace naocal
