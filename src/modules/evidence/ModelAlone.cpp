#include "evidence/ModelAlone.hpp"

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
  Eigen::MatrixXd hessian = information * problem.gram.topLeftCorner(own, own);
  hessian.diagonal() += problem.sigmas.cwiseAbs2().cwiseInverse();
  for (const PoseRows& pose : *problem.poses) {
    const Eigen::MatrixXd moved = pose.byDeflections * deflectionRoot(pose, noise) / noise.pixel;
    Eigen::MatrixXd inner = moved.transpose() * moved;
    inner.diagonal().array() += 1;
    const Eigen::LLT<Eigen::MatrixXd> factor{inner};
    logDeterminant_ += 2 * factor.matrixLLT().diagonal().array().log().sum();
    Whitener& whitener = whiteners_.emplace_back();
    whitener.half = compressed(factor.matrixL().solve(moved.transpose()));
    whitener.unknowns.noalias() = whitener.half * pose.byUnknowns / noise.pixel;
    const std::vector<std::size_t> unknowns = problem.ownUnknownsOf(pose);
    const auto answers = whitener.unknowns.leftCols(problem.ownOf(pose));
    hessian(unknowns, unknowns) -= answers.transpose() * answers;
  }
  factor_.compute(hessian);
}

ModelAlone::Outcome ModelAlone::operator()(const PoseResiduals& residuals, const Eigen::VectorXd& priorScore) const {
  const double information = 1 / (noise_.pixel * noise_.pixel);
  const Eigen::Index draws = residuals.front().cols();
  Outcome result;
  result.own = priorScore.replicate(1, draws);
  result.chi2.setZero(draws);
  for (std::size_t pose = 0; pose < residuals.size(); ++pose) {
    const PoseRows& rows = (*problem_.poses)[pose];
    const Eigen::Index own = problem_.ownOf(rows);
    const Eigen::MatrixXd bent = whiteners_[pose].half * residuals[pose] / noise_.pixel;
    result.chi2 -= bent.colwise().squaredNorm();
    result.own(problem_.ownUnknownsOf(rows), Eigen::all) +=
        information * (rows.byUnknowns.leftCols(own).transpose() * residuals[pose]) -
        whiteners_[pose].unknowns.leftCols(own).transpose() * bent;
  }
  factor_.matrixL().solveInPlace(result.own);
  result.chi2 -= result.own.colwise().squaredNorm();
  result.deviance = result.chi2.array() + logDeterminant_ + 2 * factor_.matrixLLT().diagonal().array().log().sum();
  return result;
}

} // namespace naocal
