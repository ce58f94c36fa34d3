#include "residuals/Residuals.hpp"

#include <cmath>

namespace naocal {

Eigen::MatrixXd deflectionRoot(const PoseSystem& pose, const Noise& noise) {
  const auto count = static_cast<Eigen::Index>(pose.joints.size());
  Eigen::MatrixXd root = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index first = 0; first < count;) {
    Eigen::Index size = 1;
    while (first + size < count && pose.joints[first + size] == pose.joints[first]) {
      ++size;
    }
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Constant(size, size, noise.pose * noise.pose);
    for (Eigen::Index i = 0; i < size; ++i) {
      covariance(i, i) += std::pow(noise.encoder * pose.errorScales[first + i], 2);
    }
    root.block(first, first, size, size) = covariance.llt().matrixL();
    first += size;
  }
  return root;
}

Eliminated eliminated(const PoseSystem& pose, const Noise& noise, const Eigen::MatrixXd& root) {
  const double information = 1 / (noise.pixel * noise.pixel);
  const Eigen::MatrixXd spread = pose.deflectionGram * root;
  Eliminated result;
  Eigen::MatrixXd inner = information * root.transpose() * spread;
  inner.diagonal().array() += 1;
  result.inner.compute(inner);
  result.cross = information * pose.cross * root;
  result.gradient = information * root.transpose() * pose.deflectionGradient;
  const Eigen::MatrixXd half = result.inner.matrixL().solve(result.cross.transpose());
  const Eigen::VectorXd halfGradient = result.inner.matrixL().solve(result.gradient);
  result.hessian = information * pose.unknownGram - half.transpose() * half;
  result.unknownGradient = information * pose.unknownGradient - half.transpose() * halfGradient;
  result.cost = 0.5 * (information * pose.squares - halfGradient.squaredNorm());
  return result;
}

} // namespace naocal
