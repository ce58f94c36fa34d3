#pragma once

#include "math/RigidTransform.hpp"

#include <Eigen/StdVector>
#include <cstddef>
#include <vector>

namespace naocal {

/// Where an eye stands in the world and how a target is mounted on a hand.
struct HandEye {
  RigidTransform worldFromEye, handFromTarget;
};

/// Solves worldFromHand_i * handFromTarget = worldFromEye * eyeFromTarget_i for both constant transforms: rotations by
/// the singular value decomposition of the sum of Kronecker products, then translations by linear least squares (Shah,
/// J. Mechanisms Robotics 5 (2013) 031007). Along a translation that the motions do not determine (turns about one
/// axis) the shortest one. Requires at least one pair; two turns about different axes for a unique answer.
HandEye solveHandEye(const std::vector<RigidTransform>& worldFromHand,
                     const std::vector<RigidTransform>& eyeFromTarget);

/// A point on the hand that the eye saw.
struct SeenPoint {
  RigidTransform worldFromHand;
  std::size_t point = 0; // index
  Eigen::Vector3d inEye = Eigen::Vector3d::Zero();
};

/// Where an eye stands in the world, and points on a hand that it sees.
struct PointRegistration {
  RigidTransform worldFromEye;
  std::vector<Eigen::Vector3d> inHand;
};

/// Solves worldFromEye * inEye = worldFromHand * inHand for the eye and the points: linear least squares, or the best
/// of several searches that alternate between eye and points. The linear one is exact for readings without error, but
/// where the hand turns about two axes that meet, a point where they meet fits with any eye. Shortest where
/// undetermined.
PointRegistration registerPoints(const std::vector<SeenPoint>& seen, std::size_t points);

/// The rotation nearest to a matrix (Frobenius norm).
Eigen::Matrix3d nearestRotation(const Eigen::Matrix3d& matrix);

} // namespace naocal
