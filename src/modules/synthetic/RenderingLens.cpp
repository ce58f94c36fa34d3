#include "synthetic/RenderingLens.hpp"

#include <Eigen/Geometry>
#include <array>

namespace naocal {
namespace {

/// OpenCV's five-term distortion of a point at z = 1.
Eigen::Vector2d distorted(const Eigen::Vector2d& p, const std::array<double, 5>& distortion) {
  const auto& [k1, k2, p1, p2, k3] = distortion;
  const double r2 = p.squaredNorm();
  const double radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
  return {p.x() * radial + 2 * p1 * p.x() * p.y() + p2 * (r2 + 2 * p.x() * p.x()),
          p.y() * radial + p1 * (r2 + 2 * p.y() * p.y()) + 2 * p2 * p.x() * p.y()};
}

} // namespace

Eigen::Vector2d renderedRay(const Eigen::Vector2d& pixel, const CameraIntrinsics& camera) {
  const Eigen::Vector2d given{(pixel.x() - camera.cx) / camera.fx, (pixel.y() - camera.cy) / camera.fy};
  Eigen::Vector2d p = given; // p <- p + (given - distorted(p))
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector2d step = given - distorted(p, camera.distortion);
    p += step;
    if (step.squaredNorm() < 1e-18) {
      break;
    }
  }
  return p;
}

Eigen::Vector2d renderedPixel(const Eigen::Vector3d& pointInCameraOptical, const CameraIntrinsics& camera) {
  const Eigen::Vector2d p = distorted(pointInCameraOptical.hnormalized(), camera.distortion);
  return {camera.fx * p.x() + camera.cx, camera.fy * p.y() + camera.cy};
}

} // namespace naocal
