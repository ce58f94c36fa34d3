#include "residuals/Residuals.hpp"

#include <cmath>

namespace naocal {

DeflectionRoot deflectionRoot(const PosePart& pose, const Noise& noise) {
  const auto count = static_cast<Eigen::Index>(pose.joints.size());
  DeflectionRoot root(count, count);
  root.reserve(count);
  for (Eigen::Index first = 0; first < count;) {
    Eigen::Index size = 1;
    while (first + size < count && pose.joints[first + size] == pose.joints[first]) {
      ++size;
    }
    if (size == 1) { // nearly always
      root.startVec(first);
      root.insertBack(first, first) =
          std::hypot(std::hypot(noise.encoder * pose.errorScales[first], noise.reapproach), noise.pose, noise.stance);
      ++first;
      continue;
    }
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Constant(size, size, noise.pose * noise.pose);
    for (Eigen::Index i = 0; i < size; ++i) {
      covariance(i, i) +=
          std::pow(noise.encoder * pose.errorScales[first + i], 2) + noise.reapproach * noise.reapproach;
      for (Eigen::Index j = 0; j < size; ++j) {
        covariance(i, j) += pose.stances[first + i] == pose.stances[first + j] ? noise.stance * noise.stance : 0;
      }
    }
    const Eigen::MatrixXd block = covariance.llt().matrixL();
    for (Eigen::Index column = 0; column < size; ++column) {
      root.startVec(first + column);
      for (Eigen::Index row = column; row < size; ++row) {
        root.insertBack(first + row, first + column) = block(row, column);
      }
    }
    first += size;
  }
  root.finalize();
  return root;
}

PoseSystem systemOf(const PoseRows& rows) {
  const Eigen::MatrixXd byUnknowns = rows.byUnknowns.transpose(), byDeflections = rows.byDeflections.transpose();
  return {rows,
          byUnknowns * rows.byUnknowns,
          byUnknowns * rows.byDeflections,
          byDeflections * rows.byDeflections,
          byUnknowns * rows.residual,
          byDeflections * rows.residual};
}

Eliminated eliminated(const PoseSystem& pose, const Noise& noise, const DeflectionRoot& root) {
  Eliminated result;
  eliminate(pose, noise, root, result);
  return result;
}

void eliminate(const PoseSystem& pose, const Noise& noise, const DeflectionRoot& root, Eliminated& result) {
  const double information = 1 / (noise.pixel * noise.pixel);
  const Eigen::Index unknowns = pose.unknownGradient.size(), joints = root.cols();
  result.hessian = information * pose.unknownGram;
  result.unknownGradient = information * pose.unknownGradient;
  result.cost = 0.5 * information * pose.squares;
  if (joints == 0) {
    return;
  }
  result.half.resize(joints, unknowns + 1); // the residual goes along as one more unknown
  result.half.leftCols(unknowns) = root.transpose() * pose.cross.transpose();
  result.half.col(unknowns) = root.transpose() * pose.deflectionGradient;
  result.half *= information;
  Eigen::MatrixXd spread = pose.deflectionGram * root;
  spread = (information * (root.transpose() * spread)).eval();
  spread.diagonal().array() += 1;
  result.inner.compute(spread);
  result.inner.matrixL().solveInPlace(result.half);
  const auto byUnknown = result.half.leftCols(unknowns);
  const auto byResidual = result.half.col(unknowns);
  result.hessian.noalias() -= byUnknown.transpose() * byUnknown;
  result.unknownGradient.noalias() -= byUnknown.transpose() * byResidual;
  result.cost -= 0.5 * byResidual.squaredNorm();
}

} // namespace naocal
