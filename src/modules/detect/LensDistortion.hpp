#pragma once

#include "data/Capture.hpp"

#include <Eigen/Core>

namespace naocal {

/// Conversion between distorted and undistorted pixels; straight lines are straight in the latter.
class LensDistortion {
public:
  explicit LensDistortion(const CameraIntrinsics& intrinsics) : intrinsics_{intrinsics} {}

  /// Pixel to pixel [px].
  Eigen::Vector2d undistort(const Eigen::Vector2d& pixel) const;
  Eigen::Vector2d distort(const Eigen::Vector2d& pixel) const;

private:
  CameraIntrinsics intrinsics_;
};

} // namespace naocal
