#include "estimation/Marginalization.hpp"

#include "estimation/Residuals.hpp"
#include "math/LinearAlgebra.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>

namespace naocal {

/// Deflection of each reading of its own, at least [rad]: far below any encoder's, and keeps the covariance regular
/// where an encoder's step is unknown.
constexpr double leastOwn = 1e-6;

JointErrorRoot jointErrorRoot(const PosePart& pose, const Noise& noise) {
  const auto count = static_cast<Eigen::Index>(pose.joints.size());
  JointErrorRoot root(count, count);
  root.reserve(count);
  for (Eigen::Index first = 0; first < count;) {
    Eigen::Index size = 1;
    while (first + size < count && pose.joints[first + size] == pose.joints[first]) {
      ++size;
    }
    if (size == 1) { // the usual case
      root.startVec(first);
      root.insertBack(first, first) =
          std::hypot(std::hypot(noise.encoder * pose.errorScales[first], noise.reapproach), noise.pose, noise.stance);
      ++first;
      continue;
    }
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Constant(size, size, noise.pose * noise.pose);
    for (Eigen::Index i = 0; i < size; ++i) {
      const double own = std::pow(noise.encoder * pose.errorScales[first + i], 2) + noise.reapproach * noise.reapproach;
      covariance(i, i) += std::max(own, leastOwn * leastOwn);
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

MarginalSystem marginalize(const PoseSystem& pose, const Noise& noise, const JointErrorRoot& root) {
  MarginalSystem result;
  marginalize(pose, noise, root, result);
  return result;
}

void marginalize(const PoseSystem& pose, const Noise& noise, const JointErrorRoot& root, MarginalSystem& result) {
  const double information = 1 / (noise.pixel * noise.pixel);
  const Eigen::Index unknowns = pose.unknownGradient.size(), joints = root.cols();
  result.hessian = information * pose.unknownGram;
  result.unknownGradient = information * pose.unknownGradient;
  result.cost = 0.5 * information * pose.squares;
  if (joints == 0) {
    return;
  }
  result.half.resize(joints, unknowns + 1); // the residual is appended as one more column
  result.half.leftCols(unknowns) = root.transpose() * pose.jointErrorCross.transpose();
  result.half.col(unknowns) = root.transpose() * pose.jointErrorGradient;
  result.half *= information;
  Eigen::MatrixXd spread = pose.jointErrorGram * root;
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

namespace {

/// U with U^T U = `gram` and U^T r = `gradient`, r appended as one more column: Cholesky factorisation with pivoting.
/// Stops when every direction retains less than `rounding` of its own information.
Eigen::MatrixXd factorOf(const ImageNormalEquations::Square& gram, const ImageNormalEquations::Column& gradient) {
  constexpr double rounding = 1e-13;
  const Eigen::Index width = gram.rows();
  const Eigen::VectorXd whole = gram.diagonal();
  Eigen::MatrixXd left(width, width + 1);
  left << gram, gradient;
  Eigen::MatrixXd factor(width, width + 1);
  Eigen::Index rank = 0;
  for (; rank < width; ++rank) {
    Eigen::Index pivot = 0;
    const double most = left.diagonal().cwiseQuotient(whole.cwiseMax(1e-300)).maxCoeff(&pivot);
    if (!(most > rounding)) {
      break;
    }
    factor.row(rank) = left.row(pivot) / std::sqrt(left(pivot, pivot));
    left.noalias() -= factor.row(rank).head(width).transpose() * factor.row(rank);
    left.row(pivot).setZero();
    left.col(pivot).setZero();
  }
  return factor.topRows(rank);
}

} // namespace

void RowEquations::clear(Eigen::Index columns) {
  columns_ = columns;
  parts_.clear();
}

void RowEquations::add(const ImageNormalEquations::Square& gram, const ImageNormalEquations::Column& gradient,
                       const Eigen::MatrixXd& motion, const PreparedImage::Group& group, const double* slopeValues) {
  const Eigen::Index width = gram.rows();
  const Eigen::MatrixXd factor = factorOf(gram, gradient);
  const Eigen::MatrixXd byQuantities = factor.leftCols(width) * motion.topRows(width);
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(factor.rows(), columns_ + 1);
  for (const PreparedImage::Group::Share& share : group.shares) {
    rows.col(group.columns[static_cast<std::size_t>(share.column)]) +=
        slopeValues[share.slope] * byQuantities.col(share.quantity);
  }
  rows.col(columns_) = factor.col(width);
  parts_.push_back(std::move(rows));
}

void RowEquations::takeRows(const Eigen::VectorXd& deflections, PoseRows& rows) const {
  Eigen::Index count = 0;
  for (const Eigen::MatrixXd& part : parts_) {
    count += part.rows();
  }
  Eigen::MatrixXd all(count, columns_ + 1);
  Eigen::Index next = 0;
  for (const Eigen::MatrixXd& part : parts_) {
    all.middleRows(next, part.rows()) = part;
    next += part.rows();
  }
  if (count > columns_ + 1) { // many pictures: compress the rows
    const Eigen::HouseholderQR<Eigen::MatrixXd> turned{all};
    all = turned.matrixQR().topRows(columns_ + 1).triangularView<Eigen::Upper>();
  }
  const Eigen::Index unknowns = eigenIndex(rows.unknowns.size());
  rows.byUnknowns = all.leftCols(unknowns);
  rows.byDeflections = all.middleCols(unknowns, deflections.size());
  rows.residual = all.col(columns_);
  const Eigen::VectorXd bent = rows.byDeflections * deflections;
  rows.squares += bent.squaredNorm() - 2 * bent.dot(rows.residual);
  rows.residual -= bent;
}

} // namespace naocal
