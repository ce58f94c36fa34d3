#pragma once

#include "data/Capture.hpp"

#include <Eigen/Core>

namespace naocal {

/// The point at z = 1 that is seen at a pixel, and the pixel where a point before the camera is seen.
/// Written for rendering alone, apart from the calibration's projection that the pictures shall check.
Eigen::Vector2d renderedRay(const Eigen::Vector2d& pixel, const CameraIntrinsics& camera);
Eigen::Vector2d renderedPixel(const Eigen::Vector3d& pointInCameraOptical, const CameraIntrinsics& camera);

} // namespace naocal
