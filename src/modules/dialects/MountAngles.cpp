#include "dialects/MountAngles.hpp"

#include "math/RigidTransform.hpp"

#include <algorithm>
#include <cmath>

namespace naocal {
namespace {

double arcSine(double sine) {
  return std::asin(std::clamp(sine, -1.0, 1.0)); // rounding
}

} // namespace

Eigen::Matrix3d rotationXyz(const Eigen::Vector3d& angles) {
  return rotationX(angles.x()) * rotationY(angles.y()) * rotationZ(angles.z());
}

Eigen::Matrix3d rotationYxz(const Eigen::Vector3d& angles) {
  return rotationY(angles.y()) * rotationX(angles.x()) * rotationZ(angles.z());
}

Eigen::Matrix3d rotationZyx(const Eigen::Vector3d& angles) {
  return rotationZ(angles.z()) * rotationY(angles.y()) * rotationX(angles.x());
}

Eigen::Vector3d anglesXyz(const Eigen::Matrix3d& r) {
  return {std::atan2(-r(1, 2), r(2, 2)), arcSine(r(0, 2)), std::atan2(-r(0, 1), r(0, 0))};
}

Eigen::Vector3d anglesYxz(const Eigen::Matrix3d& r) {
  return {arcSine(-r(1, 2)), std::atan2(r(0, 2), r(2, 2)), std::atan2(r(1, 0), r(1, 1))};
}

Eigen::Vector3d anglesZyx(const Eigen::Matrix3d& r) {
  return {std::atan2(r(2, 1), r(2, 2)), arcSine(-r(2, 0)), std::atan2(r(1, 0), r(0, 0))};
}

} // namespace naocal
