#include "camera/BoardPose.hpp"

#include "math/LinearAlgebra.hpp"

#include <Eigen/SVD>
#include <algorithm>
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

/// Corners on a flat board, with the rays (X/Z, Y/Z) that see them.
struct SeenPoints {
  std::vector<Eigen::Vector2d> onBoard, rays; // onBoard: x, y [m]
};

SeenPoints collectPoints(const CornerBlocks& corners, const Eigen::Matrix<double, 9, 1>& lens) {
  SeenPoints points;
  for (const CornerBlock& block : corners) {
    for (Eigen::Index i = 0; i < 4; ++i) {
      if (block.present[i] > 0) {
        points.onBoard.emplace_back(block.x[i], block.y[i]);
        points.rays.push_back(undistort(block.u[i], block.v[i], lens));
      }
    }
  }
  return points;
}

/// Mean and scatter matrix, sum (p - mean) (p - mean)^T, of points.
struct Scatter {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
};

Scatter scatterOf(const std::vector<Eigen::Vector2d>& points) {
  Scatter scatter;
  for (const Eigen::Vector2d& point : points) {
    scatter.mean += point / static_cast<double>(points.size());
  }
  for (const Eigen::Vector2d& point : points) {
    scatter.matrix += (point - scatter.mean) * (point - scatter.mean).transpose();
  }
  return scatter;
}

/// H with rays = H * (point - centre) / size by the direct linear transformation; columns: r1 size, r2 size, t, scaled
/// so that r1 and r2 have length 1 on average, and the board lies before the camera.
Eigen::Matrix3d estimateHomography(const SeenPoints& points, const Eigen::Vector2d& centre, double size) {
  Eigen::MatrixXd system(2 * static_cast<Eigen::Index>(points.rays.size()), 9);
  for (std::size_t i = 0; i < points.rays.size(); ++i) {
    const Eigen::Vector3d p = ((points.onBoard[i] - centre) / size).homogeneous();
    const auto row = 2 * static_cast<Eigen::Index>(i);
    system.row(row) << p.transpose(), 0, 0, 0, -points.rays[i].x() * p.transpose();
    system.row(row + 1) << 0, 0, 0, p.transpose(), -points.rays[i].y() * p.transpose();
  }
  const Eigen::VectorXd h = symmetricEigen(system.transpose() * system).vectors.col(0);
  Eigen::Matrix3d homography;
  homography << h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7], h[8];
  homography *= (homography(2, 2) < 0 ? -2 : 2) / (homography.col(0).norm() + homography.col(1).norm());
  return homography;
}

/// Rotation closest to the axes r1, r2 of a homography and their cross product.
Eigen::Matrix3d nearestRotation(const Eigen::Matrix3d& homography) {
  Eigen::Matrix3d axes;
  axes << homography.col(0), homography.col(1), homography.col(0).cross(homography.col(1));
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd{axes, Eigen::ComputeFullU | Eigen::ComputeFullV};
  return svd.matrixU() * svd.matrixV().transpose();
}

/// Whether all points lie on a line, or all but one: they leave the homography open.
bool areOnLine(const std::vector<Eigen::Vector2d>& points) {
  constexpr double narrow = 1e-3; // ratio of the squared width to the squared length
  const Scatter all = scatterOf(points);
  const auto isNarrow = [](const Eigen::Matrix2d& scatter) {
    const Eigen::Vector2d spreads = symmetricEigenvalues(scatter);
    return spreads[0] < narrow * spreads[1];
  };
  const auto count = static_cast<double>(points.size());
  return isNarrow(all.matrix) || std::any_of(points.begin(), points.end(), [&](const Eigen::Vector2d& point) {
           const Eigen::Vector2d away = point - all.mean;
           return isNarrow(all.matrix - count / (count - 1) * away * away.transpose()); // without this point
         });
}

} // namespace

std::optional<RigidTransform> estimateBoardPose(const CornerBlocks& corners, const Eigen::Matrix<double, 9, 1>& lens) {
  const SeenPoints points = collectPoints(corners, lens);
  const std::size_t count = points.rays.size();
  if (count < 4) {
    return std::nullopt;
  }
  if (areOnLine(points.onBoard)) {
    return std::nullopt;
  }
  const Scatter scatter = scatterOf(points.onBoard);
  const double size = std::sqrt(scatter.matrix.trace() / static_cast<double>(count));
  const Eigen::Matrix3d homography = estimateHomography(points, scatter.mean, size);
  RigidTransform result;
  result.rotation = nearestRotation(homography);
  const Eigen::Vector3d centreInOptical = homography.col(2) * size;
  result.translation = centreInOptical - result.rotation * Eigen::Vector3d{scatter.mean.x(), scatter.mean.y(), 0};
  if (result.rotation.determinant() < 0 || centreInOptical.z() <= 0) {
    return std::nullopt;
  }
  return result;
}

} // namespace naocal
