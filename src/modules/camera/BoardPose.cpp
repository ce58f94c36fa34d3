#include "camera/BoardPose.hpp"

#include "math/LinearAlgebra.hpp"

#include <Eigen/SVD>
#include <cmath>

namespace naocal {

namespace {

/// (X/Z, Y/Z) that the lens maps to the pixel (u, v), by fixed-point iteration on the distortion.
Eigen::Vector2d undistort(double u, double v, const Eigen::Matrix<double, 9, 1>& lens) {
  const Eigen::Vector2d seen{(u - lens[2]) / lens[0], (v - lens[3]) / lens[1]};
  Eigen::Vector2d ray = seen;
  for (int i = 0; i < 20; ++i) {
    const double x = ray.x(), y = ray.y(), rr = x * x + y * y;
    const double radial = 1 + rr * (lens[4] + rr * (lens[5] + rr * lens[8]));
    const Eigen::Vector2d tangential{2 * lens[6] * x * y + lens[7] * (rr + 2 * x * x),
                                     lens[6] * (rr + 2 * y * y) + 2 * lens[7] * x * y};
    ray = (seen - tangential) / radial;
  }
  return ray;
}

} // namespace

std::optional<RigidTransform> estimateBoardPose(const CornerBlocks& corners, const Eigen::Matrix<double, 9, 1>& lens) {
  std::vector<Eigen::Vector2d> points, rays;
  for (const CornerBlock& block : corners) {
    for (Eigen::Index i = 0; i < 4; ++i) {
      if (block.present[i] > 0) {
        points.emplace_back(block.x[i], block.y[i]);
        rays.push_back(undistort(block.u[i], block.v[i], lens));
      }
    }
  }
  if (points.size() < 4) {
    return std::nullopt;
  }
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& point : points) {
    centre += point / static_cast<double>(points.size());
  }
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector2d& point : points) {
    spread += (point - centre) * (point - centre).transpose();
  }
  const Eigen::Vector2d spreads = symmetricEigenvalues(spread);
  if (spreads[0] < 1e-3 * spreads[1]) {
    return std::nullopt;
  }
  const double size = std::sqrt(spread.trace() / static_cast<double>(points.size()));
  Eigen::MatrixXd system(2 * static_cast<Eigen::Index>(points.size()), 9);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d p = ((points[i] - centre) / size).homogeneous();
    const auto row = 2 * static_cast<Eigen::Index>(i);
    system.row(row) << p.transpose(), 0, 0, 0, -rays[i].x() * p.transpose();
    system.row(row + 1) << 0, 0, 0, p.transpose(), -rays[i].y() * p.transpose();
  }
  const Eigen::VectorXd h = symmetricEigen(system.transpose() * system).vectors.col(0);
  Eigen::Matrix3d homography; // rays = homography * (point - centre) / size; columns: r1 size, r2 size, t
  homography << h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7], h[8];
  homography *= (homography(2, 2) < 0 ? -2 : 2) / (homography.col(0).norm() + homography.col(1).norm());
  Eigen::Matrix3d axes;
  axes << homography.col(0), homography.col(1), homography.col(0).cross(homography.col(1));
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd{axes, Eigen::ComputeFullU | Eigen::ComputeFullV};
  RigidTransform result;
  result.rotation = svd.matrixU() * svd.matrixV().transpose();
  const Eigen::Vector3d centreInOptical = homography.col(2) * size;
  result.translation = centreInOptical - result.rotation * Eigen::Vector3d{centre.x(), centre.y(), 0};
  if (result.rotation.determinant() < 0 || centreInOptical.z() <= 0) {
    return std::nullopt;
  }
  return result;
}

} // namespace naocal
