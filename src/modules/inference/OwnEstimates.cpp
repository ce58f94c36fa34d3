#include "inference/OwnEstimates.hpp"

#include "inference/Thresholds.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>

namespace naocal {

namespace {

/// Precision of a model's own unknowns at a misfit.
Eigen::MatrixXd temper(const NullModel& model, double misfit) {
  return temperPrecision(model.factor().reconstructedMatrix(), model.problem().sigmas, misfit);
}

} // namespace

Eigen::MatrixXd temperPrecision(const Eigen::MatrixXd& precision, const Eigen::VectorXd& sigmas, double misfit) {
  Eigen::MatrixXd result = precision / misfit;
  result.diagonal() += (1 - 1 / misfit) * sigmas.cwiseAbs2().cwiseInverse();
  return result;
}

OwnEstimates::OwnEstimates(const LinearWindow& linear, double misfit)
    : misfit_{misfit}, sigmas_{linear.alone.problem().sigmas}, reference_{linear.alone.problem().unknowns} {
  const auto& factor = linear.alone.factor();
  const Eigen::LLT<Eigen::MatrixXd> tempered{temper(linear.alone, misfit)};
  const Eigen::VectorXd prior = linear.alone.problem().priorScore(), all = factor.matrixL() * linear.own,
                        scores = (all - prior) / misfit + prior;
  fullAnswers_ = factor.matrixU().solve(linear.explained);
  answers_ = misfit > 1 ? tempered.solve(factor.matrixL() * linear.explained / misfit) : fullAnswers_;
  alone_ = reference_ - tempered.solve(scores) + answers_ * linear.sizes;
  score_ = (linear.score - fullAnswers_.transpose() * all + linear.pull) / misfit + answers_.transpose() * scores +
           freed(fullAnswers_, answers_ * linear.sizes);
  covariance_ = tempered.solve(Eigen::MatrixXd::Identity(sigmas_.size(), sigmas_.size()));
  findTold(linear.plain ? *linear.plain : linear.alone);
}

Eigen::MatrixXd OwnEstimates::freed(const Eigen::MatrixXd& fullAnswers, const Eigen::MatrixXd& answers) const {
  return (1 - 1 / misfit_) * (fullAnswers.transpose() * sigmas_.cwiseAbs2().cwiseInverse().asDiagonal() * answers);
}

void OwnEstimates::findTold(const NullModel& plain) {
  Eigen::MatrixXd precision = sigmas_.asDiagonal() * temper(plain, misfit_) * sigmas_.asDiagonal(); // of a prior: 1
  const SymmetricEigen informed = symmetricEigen(precision);
  const Eigen::Index untold = (informed.values.array() < 1 + threshold::untold).count();
  const auto left = informed.vectors.leftCols(untold);
  told_ = Eigen::MatrixXd::Identity(sigmas_.size(), sigmas_.size()) - left * left.transpose();
  const Eigen::VectorXd inverse = sigmas_.cwiseInverse();
  const Eigen::MatrixXd scaled =
      told_ * (inverse.asDiagonal() * covariance_ * inverse.asDiagonal()) * told_ + left * left.transpose();
  covariance_ = sigmas_.asDiagonal() * scaled * sigmas_.asDiagonal();
  const SymmetricEigen known = symmetricEigen(scaled);
  directions_ = known.vectors;
  shares_ = known.values;
}

OwnEstimate OwnEstimates::estimate(const std::vector<Eigen::Index>& columns, const Eigen::MatrixXd& information,
                                   const Eigen::VectorXd& widths) const {
  OwnEstimate result{alone_, Eigen::MatrixXd::Zero(sigmas_.size(), 0), {}, {}};
  if (!columns.empty()) {
    const Eigen::MatrixXd answers = answers_(Eigen::all, columns);
    Eigen::MatrixXd precision = information / misfit_ + freed(fullAnswers_(Eigen::all, columns), answers);
    precision.diagonal() += widths.cwiseAbs2().cwiseInverse();
    const Eigen::LLT<Eigen::MatrixXd> factor{precision};
    result.coefficients = factor.solve(score_(columns));
    result.value -= answers * result.coefficients;
    result.coefficientSpread = factor.matrixU().solve(Eigen::MatrixXd::Identity(precision.rows(), precision.cols()));
    result.spread = -answers * result.coefficientSpread;
  }
  const Eigen::MatrixXd told = toldInUnits();
  result.value = reference_ + told * (result.value - reference_);
  result.spread = told * result.spread;
  keepPlausible(result);
  return result;
}

UnnoticedBiases OwnEstimates::findUnnoticed(const std::vector<Eigen::Index>& columns,
                                            const Eigen::MatrixXd& information, const Eigen::VectorXd& widths,
                                            double noticed) const {
  const Eigen::MatrixXd answers = answers_(Eigen::all, columns);
  Eigen::MatrixXd precision = information / misfit_ + freed(fullAnswers_(Eigen::all, columns), answers);
  const Eigen::Index own = widths.size(), further = precision.rows() - own;
  precision.diagonal().head(own) += widths.cwiseAbs2().cwiseInverse();
  const Eigen::MatrixXd taken = precision.topLeftCorner(own, own).llt().solve(precision.topRightCorner(own, further));
  Eigen::MatrixXd unnoticed =
      (precision.bottomRightCorner(further, further) - precision.bottomLeftCorner(further, own) * taken) / noticed;
  unnoticed.diagonal().array() += 1 / (threshold::implausible * threshold::implausible);
  const Eigen::MatrixXd biases = toldInUnits() * (answers.rightCols(further) - answers.leftCols(own) * taken);
  const Eigen::MatrixXd coefficients =
      unnoticed.llt().matrixU().solve(Eigen::MatrixXd::Identity(unnoticed.rows(), unnoticed.cols()));
  return {biases * coefficients, coefficients};
}

Eigen::MatrixXd OwnEstimates::toldInUnits() const {
  return sigmas_.asDiagonal() * told_ * sigmas_.cwiseInverse().asDiagonal();
}

void OwnEstimates::keepPlausible(OwnEstimate& estimate) const {
  const Eigen::ArrayXd start = reference_.cwiseQuotient(sigmas_).array(),
                       most = (start.abs() + 1).max(threshold::farthest);
  Eigen::VectorXd change = (estimate.value - reference_).cwiseQuotient(sigmas_);
  Eigen::Index kept = change.size();
  while (kept > 0 && ((start + change.array()).abs() > most).any()) {
    --kept;
    change -= directions_.col(kept) * directions_.col(kept).dot(change);
  }
  if (kept == change.size()) {
    return;
  }
  estimate.value = reference_ + sigmas_.cwiseProduct(change);
  const auto used = directions_.leftCols(kept);
  const auto left = directions_.rightCols(change.size() - kept);
  const Eigen::MatrixXd told = used * (used.transpose() * (sigmas_.cwiseInverse().asDiagonal() * estimate.spread));
  const Eigen::VectorXd missing = (1 - shares_.tail(left.cols()).array()).max(0).sqrt();
  estimate.spread.resize(change.size(), told.cols() + left.cols());
  estimate.spread << sigmas_.asDiagonal() * told, sigmas_.asDiagonal() * left * missing.asDiagonal();
  const Eigen::Index coefficients = estimate.coefficientSpread.cols();
  estimate.coefficientSpread.conservativeResizeLike(
      Eigen::MatrixXd::Zero(estimate.coefficientSpread.rows(), coefficients + left.cols()));
}

} // namespace naocal
