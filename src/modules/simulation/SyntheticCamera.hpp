#pragma once

#include "data/Capture.hpp"

#include <Eigen/Geometry>
#include <optional>
#include <vector>

namespace naocal {

/// parentFromFrame = T(x, y, z) Rz(yaw) Ry(pitch) Rx(roll).
Eigen::Isometry3d isometryFromPlacement(const Placement& placement);

/// Projects a point with OpenCV's pinhole and distortion model (k1, k2, p1, p2, k3), camera axes x forward, y left, z
/// up: x = -Y/X, y = -Z/X, r^2 = x^2 + y^2, g = 1 + k1 r^2 + k2 r^4 + k3 r^6,
///   u = fx (x g + 2 p1 x y + p2 (r^2 + 2 x^2)) + cx,   v = fy (y g + p1 (r^2 + 2 y^2) + 2 p2 x y) + cy   [px].
/// Absent behind the camera and where the distortion folds the image over (d(r g)/dr <= 0).
std::optional<Eigen::Vector2d> projectPoint(const CameraIntrinsics& camera, const Eigen::Vector3d& pointInCamera);

/// Minimum height of a board's square [px]; below it the detector misses most corners.
constexpr double smallestSquare = 12;

/// The corners that a detector would find, without noise: inside the image, on squares at least `smallestSquare` pixels
/// high including foreshortening, and at least six. Ignores occlusion by the robot's body.
BoardCorners visibleCorners(const CameraIntrinsics& camera, const Board& board,
                            const Eigen::Isometry3d& cameraFromBoard);

} // namespace naocal
