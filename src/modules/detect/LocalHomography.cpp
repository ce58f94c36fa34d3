#include "detect/LocalHomography.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace naocal {
namespace {

constexpr double scope = 2;         // [squares]
constexpr double perspective = 0.1; // how much nearer the next square typically is: tames four noisy corners

/// Moves the sightings' weighted mean to zero and their spread to about one.
Eigen::Matrix3d normalisation(const std::vector<SeenPoint>& sightings) {
  double sum = 0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const SeenPoint& one : sightings) {
    sum += one.weight;
    mean += one.weight * one.seenAt;
  }
  mean /= sum;
  double spread = 0;
  for (const SeenPoint& one : sightings) {
    spread += one.weight * (one.seenAt - mean).squaredNorm();
  }
  const double scale = std::sqrt(2 * sum / spread);
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  matrix.topLeftCorner<2, 2>() *= scale;
  matrix.topRightCorner<2, 1>() = -scale * mean;
  return matrix;
}

} // namespace

std::optional<Eigen::Matrix3d> localHomography(const std::vector<SeenPoint>& sightings, const Eigen::Vector2d& around) {
  if (sightings.size() < 4) {
    return std::nullopt;
  }
  const Eigen::Matrix3d normalised = normalisation(sightings);
  Eigen::Matrix<double, 9, 9> normal = Eigen::Matrix<double, 9, 9>::Zero();
  for (const SeenPoint& one : sightings) {
    const Eigen::Vector3d x = (one.onBoard - around).homogeneous();
    const Eigen::Vector2d u = (normalised * one.seenAt.homogeneous()).head<2>();
    const double nearness = 1 / (1 + (one.onBoard - around).squaredNorm() / (scope * scope));
    Eigen::Matrix<double, 2, 9> rows;
    rows << x.transpose(), Eigen::RowVector3d::Zero(), -u.x() * x.transpose(), //
        Eigen::RowVector3d::Zero(), x.transpose(), -u.y() * x.transpose();
    normal += one.weight * nearness * nearness * rows.transpose() * rows;
  }
  const double scale = normalised(0, 0);
  normal.diagonal().segment<2>(6).array() += std::pow(scale * unitSigma / perspective, 2);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 9, 9>> solver{normal};
  const Eigen::Matrix<double, 9, 1> h = solver.eigenvectors().col(0);
  Eigen::Matrix3d centred;
  centred << h.head<3>().transpose(), h.segment<3>(3).transpose(), h.tail<3>().transpose();
  Eigen::Matrix3d shift = Eigen::Matrix3d::Identity();
  shift.topRightCorner<2, 1>() = -around;
  return normalised.inverse() * centred * shift;
}

} // namespace naocal
