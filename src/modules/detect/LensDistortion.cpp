#include "detect/LensDistortion.hpp"

#include <opencv2/calib3d.hpp>
#include <vector>

namespace naocal {
namespace {

cv::Matx33d cameraMatrix(const CameraIntrinsics& camera) {
  return {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1};
}

} // namespace

Eigen::Vector2d LensDistortion::undistort(const Eigen::Vector2d& pixel) const {
  const std::vector<cv::Point2d> seen{{pixel.x(), pixel.y()}};
  std::vector<cv::Point2d> ideal;
  const cv::Matx33d matrix = cameraMatrix(intrinsics_);
  const cv::TermCriteria untilExact{cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 50, 1e-9};
  cv::undistortPoints(seen, ideal, matrix, intrinsics_.distortion, cv::noArray(), matrix, untilExact);
  return {ideal[0].x, ideal[0].y};
}

Eigen::Vector2d LensDistortion::distort(const Eigen::Vector2d& pixel) const {
  const auto& [k1, k2, p1, p2, k3] = intrinsics_.distortion;
  const double x = (pixel.x() - intrinsics_.cx) / intrinsics_.fx, y = (pixel.y() - intrinsics_.cy) / intrinsics_.fy;
  const double r2 = x * x + y * y;
  const double radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
  return {intrinsics_.fx * (x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x)) + intrinsics_.cx,
          intrinsics_.fy * (y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y) + intrinsics_.cy};
}

} // namespace naocal
