#pragma once

#include <Eigen/Core>

namespace naocal {

/// A change of frame: pointInDestination = destinationFromSource * pointInSource.
///
/// Named `destinationFromSource`; equal names meet across `*`: `headFromBoard = headFromCamera * cameraFromBoard`.
struct RigidTransform {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero(); // [m]

  RigidTransform operator*(const RigidTransform& other) const {
    return {rotation * other.rotation, rotation * other.translation + translation};
  }
  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const { return rotation * point + translation; }
  RigidTransform inverse() const { return {rotation.transpose(), -(rotation.transpose() * translation)}; }
};

/// Right-handed rotations about the axes of a frame by an angle [rad].
Eigen::Matrix3d rotationX(double angle);
Eigen::Matrix3d rotationY(double angle);
Eigen::Matrix3d rotationZ(double angle);

/// The angles x, y, z [rad] with rotation = rotationX(x) * rotationY(y) * rotationZ(z); y within a quarter turn.
Eigen::Vector3d turnsAboutXyz(const Eigen::Matrix3d& rotation);

/// exp([v]x): the rotation about `rotationVector` by its length [rad] (Rodrigues).
Eigen::Matrix3d rotationAbout(const Eigen::Vector3d& rotationVector);

/// J with exp([v + dv]x) = exp([J dv]x) exp([v]x) to first order: left Jacobian of the rotation vector.
/// J = sin(t)/t I + (1 - cos t)/t^2 [v]x + (t - sin t)/t^3 v v^T, t = |v|.
Eigen::Matrix3d leftJacobian(const Eigen::Vector3d& rotationVector);

/// [v]x with [v]x w = v x w.
Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v);

/// Axes of an optical frame (x right, y down, z forward) from those of a camera (x forward, y left, z up):
/// vectorInOptical = opticalFromCamera() * vectorInCamera.
Eigen::Matrix3d opticalFromCamera();

} // namespace naocal
