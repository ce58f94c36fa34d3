#include "evidence/ModelAlone.hpp"

#include "math/Parallel.hpp"

#include <Eigen/QR>

namespace naocal {

namespace {

/// What has the same product with itself, and no more rows than columns.
Eigen::MatrixXd compressed(const Eigen::MatrixXd& half) {
  if (half.rows() <= half.cols()) {
    return half;
  }
  return Eigen::HouseholderQR<Eigen::MatrixXd>{half}.matrixQR().topRows(half.cols()).triangularView<Eigen::Upper>();
}

} // namespace

ModelAlone::ModelAlone(const ScoreProblem& problem, const Noise& noise) : problem_{problem}, noise_{noise} {
  const double information = 1 / (noise.pixel * noise.pixel);
  const Eigen::Index own = problem.own();
  whiteners_.resize(problem.poses->size());
  Eigen::MatrixXd hessian = information * problem.gram.topLeftCorner(own, own);
  hessian.diagonal() += problem.sigmas.cwiseAbs2().cwiseInverse();
  const auto none = [&] { return Taken{Eigen::MatrixXd::Zero(own, own)}; };
  const auto take = [&](std::size_t pose, Taken& taken) { takeDeflections(pose, taken); };
  for (const Taken& part : gatheredInParts(whiteners_.size(), none, take)) {
    hessian -= part.information;
    logDeterminant_ += part.logDeterminant;
  }
  factor_.compute(hessian);
}

void ModelAlone::takeDeflections(std::size_t pose, Taken& taken) {
  const PoseRows& rows = (*problem_.poses)[pose];
  const Eigen::MatrixXd moved = rows.byDeflections * deflectionRoot(rows, noise_) / noise_.pixel;
  Eigen::MatrixXd inner = moved.transpose() * moved;
  inner.diagonal().array() += 1;
  const Eigen::LLT<Eigen::MatrixXd> factor{inner};
  taken.logDeterminant += 2 * factor.matrixLLT().diagonal().array().log().sum();
  Whitener& whitener = whiteners_[pose];
  whitener.half = compressed(factor.matrixL().solve(moved.transpose()));
  whitener.unknowns.noalias() = whitener.half * rows.byUnknowns / noise_.pixel;
  const std::vector<std::size_t> unknowns = problem_.ownUnknownsOf(rows);
  const auto answers = whitener.unknowns.leftCols(problem_.ownOf(rows));
  taken.information(unknowns, unknowns) += answers.transpose() * answers;
}

ModelAlone::Outcome ModelAlone::operator()(const PoseResiduals& residuals, const Eigen::VectorXd& priorScore) const {
  const double information = 1 / (noise_.pixel * noise_.pixel);
  const Eigen::Index draws = residuals.front().cols();
  Outcome result;
  result.own = priorScore.replicate(1, draws);
  result.chi2.setZero(draws);
  const auto none = [&] {
    return Outcome{.deviance = {},
                   .chi2 = Eigen::RowVectorXd::Zero(draws),
                   .own = Eigen::MatrixXd::Zero(priorScore.size(), draws)};
  };
  const auto add = [&](std::size_t pose, Outcome& sum) {
    const PoseRows& rows = (*problem_.poses)[pose];
    const Eigen::Index own = problem_.ownOf(rows);
    const Eigen::MatrixXd bent = whiteners_[pose].half * residuals[pose] / noise_.pixel;
    sum.chi2 -= bent.colwise().squaredNorm();
    sum.own(problem_.ownUnknownsOf(rows), Eigen::all) +=
        information * (rows.byUnknowns.leftCols(own).transpose() * residuals[pose]) -
        whiteners_[pose].unknowns.leftCols(own).transpose() * bent;
  };
  for (const Outcome& part : gatheredInParts(residuals.size(), none, add)) {
    result.chi2 += part.chi2;
    result.own += part.own;
  }
  factor_.matrixL().solveInPlace(result.own);
  result.chi2 -= result.own.colwise().squaredNorm();
  result.deviance = result.chi2.array() + logDeterminant_ + 2 * factor_.matrixLLT().diagonal().array().log().sum();
  return result;
}

} // namespace naocal
