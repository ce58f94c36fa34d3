#include "residuals/RowEquations.hpp"

#include "math/LinearAlgebra.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>

namespace naocal {

namespace {

/// U with U^T U = `gram` and U^T r = `gradient`, r behind it as one more column: a Cholesky factorisation with pivots.
/// What is left is taken for rounding where no direction has more than `rounding` of its own information.
Eigen::MatrixXd factorOf(const PictureGram::Square& gram, const PictureGram::Column& gradient) {
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

void RowEquations::add(const PictureGram::Square& gram, const PictureGram::Column& gradient,
                       const Eigen::MatrixXd& motion, const PreparedPicture::Group& group, const double* slopeValues) {
  const Eigen::Index width = gram.rows();
  const Eigen::MatrixXd factor = factorOf(gram, gradient);
  const Eigen::MatrixXd byQuantities = factor.leftCols(width) * motion.topRows(width);
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(factor.rows(), columns_ + 1);
  for (const PreparedPicture::Group::Share& share : group.shares) {
    rows.col(group.columns[static_cast<std::size_t>(share.column)]) +=
        slopeValues[share.slope] * byQuantities.col(share.quantity);
  }
  rows.col(columns_) = factor.col(width);
  parts_.push_back(std::move(rows));
}

void RowEquations::take(const Eigen::VectorXd& deflections, PoseRows& rows) const {
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
  if (count > columns_ + 1) { // a pose of many pictures
    const Eigen::HouseholderQR<Eigen::MatrixXd> turned{all};
    all = turned.matrixQR().topRows(columns_ + 1).triangularView<Eigen::Upper>();
  }
  const Eigen::Index unknowns = at(rows.unknowns.size());
  rows.byUnknowns = all.leftCols(unknowns);
  rows.byDeflections = all.middleCols(unknowns, deflections.size());
  rows.residual = all.col(columns_);
  const Eigen::VectorXd bent = rows.byDeflections * deflections;
  rows.squares += bent.squaredNorm() - 2 * bent.dot(rows.residual);
  rows.residual -= bent;
}

} // namespace naocal
