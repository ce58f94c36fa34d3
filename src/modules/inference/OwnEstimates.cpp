#include "inference/OwnEstimates.hpp"

#include "inference/Thresholds.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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
           (1 - 1 / misfit) * (fullAnswers_.transpose() *
                               (sigmas_.cwiseAbs2().cwiseInverse().asDiagonal() * (answers_ * linear.sizes)));
  covariance_ = inverse(tempered);
  leaveUntold(linear.plain ? *linear.plain : linear.alone);
}

Eigen::MatrixXd OwnEstimates::informationOf(const std::vector<Eigen::Index>& columns,
                                            const Eigen::MatrixXd& projected) const {
  const Eigen::MatrixXd held = held_(Eigen::all, columns);
  return projected / misfit_ +
         (1 - 1 / misfit_) * (fullAnswers_(Eigen::all, columns).transpose() *
                              sigmas_.cwiseAbs2().cwiseInverse().asDiagonal() * answers_(Eigen::all, columns)) +
         held.transpose() * held;
}

void OwnEstimates::leaveUntold(const NullModel& plain) {
  Eigen::MatrixXd precision = sigmas_.asDiagonal() * temper(plain, misfit_) * sigmas_.asDiagonal(); // of a prior: 1
  const SymmetricEigen informed = symmetricEigen(precision);
  const Eigen::Index untold = (informed.values.array() < 1 + threshold::untold).count();
  const auto left = informed.vectors.leftCols(untold);
  const Eigen::VectorXd inverse = sigmas_.cwiseInverse();
  const Eigen::MatrixXd known = inverse.asDiagonal() * covariance_ * inverse.asDiagonal();
  const Eigen::LLT<Eigen::MatrixXd> alongLeft{left.transpose() * known * left};
  const Eigen::MatrixXd towards = left.transpose() * inverse.asDiagonal();
  held_ = alongLeft.matrixL().solve(towards * answers_);
  score_ += held_.transpose() * alongLeft.matrixL().solve(towards * (alone_ - reference_));

  const Eigen::MatrixXd given = Eigen::MatrixXd::Identity(sigmas_.size(), sigmas_.size()) -
                                known * left * alongLeft.solve(left.transpose()),
                        givenInUnits = sigmas_.asDiagonal() * given * inverse.asDiagonal();
  alone_ = reference_ + givenInUnits * (alone_ - reference_);
  answers_ = givenInUnits * answers_;
  Eigen::MatrixXd scaled = given * known + left * left.transpose();
  scaled = 0.5 * (scaled + scaled.transpose()).eval();
  covariance_ = sigmas_.asDiagonal() * scaled * sigmas_.asDiagonal();
  const SymmetricEigen axes = symmetricEigen(scaled);
  directions_ = axes.vectors;
  shares_ = axes.values;
}

OwnEstimate OwnEstimates::estimate(const std::vector<Eigen::Index>& columns, const Eigen::MatrixXd& information,
                                   const Eigen::VectorXd& widths) const {
  OwnEstimate result{alone_, Eigen::MatrixXd::Zero(sigmas_.size(), 0), {}, {}};
  if (!columns.empty()) {
    const Eigen::MatrixXd answers = answers_(Eigen::all, columns);
    Eigen::MatrixXd precision = informationOf(columns, information);
    precision.diagonal() += widths.cwiseAbs2().cwiseInverse();
    const Eigen::LLT<Eigen::MatrixXd> factor{precision};
    result.coefficients = factor.solve(score_(columns));
    result.value -= answers * result.coefficients;
    result.coefficientSpread = factor.matrixU().solve(Eigen::MatrixXd::Identity(precision.rows(), precision.cols()));
    result.spread = -answers * result.coefficientSpread;
  }
  keepPlausible(result);
  return result;
}

UnnoticedBiases OwnEstimates::findUnnoticed(const std::vector<Eigen::Index>& columns,
                                            const Eigen::MatrixXd& information, const Eigen::VectorXd& widths,
                                            double noticed) const {
  const Eigen::MatrixXd answers = answers_(Eigen::all, columns);
  Eigen::MatrixXd precision = informationOf(columns, information);
  const Eigen::Index own = widths.size(), further = precision.rows() - own;
  precision.diagonal().head(own) += widths.cwiseAbs2().cwiseInverse();
  const Eigen::MatrixXd taken = precision.topLeftCorner(own, own).llt().solve(precision.topRightCorner(own, further));
  Eigen::MatrixXd unnoticed =
      (precision.bottomRightCorner(further, further) - precision.bottomLeftCorner(further, own) * taken) / noticed;
  unnoticed.diagonal().array() += 1 / (threshold::implausible * threshold::implausible);
  const Eigen::MatrixXd coefficients =
      unnoticed.llt().matrixU().solve(Eigen::MatrixXd::Identity(unnoticed.rows(), unnoticed.cols()));
  return {(answers.rightCols(further) - answers.leftCols(own) * taken) * coefficients, coefficients,
          taken * coefficients};
}

OwnEstimate OwnEstimates::leaveToPriors(const Eigen::MatrixXd& left, const Eigen::VectorXd& shares,
                                        OwnEstimate estimate) const {
  const Eigen::VectorXd inverse = sigmas_.cwiseInverse();
  if (estimate.spread.cols() > 0) {
    const Eigen::MatrixXd along = left.transpose() * inverse.asDiagonal() * estimate.spread,
                          weighed = shares.cwiseInverse().asDiagonal() * along;
    const Eigen::VectorXd away = left.transpose() * inverse.cwiseProduct(estimate.value - reference_);
    const Eigen::LLT<Eigen::MatrixXd> precision{Eigen::MatrixXd::Identity(along.cols(), along.cols()) +
                                                along.transpose() * weighed};
    const Eigen::VectorXd back = precision.solve(weighed.transpose() * away);
    const Eigen::MatrixXd half = precision.matrixU().solve(Eigen::MatrixXd::Identity(along.cols(), along.cols()));
    estimate.value -= estimate.spread * back;
    estimate.coefficients -= estimate.coefficientSpread * back;
    estimate.spread *= half;
    estimate.coefficientSpread *= half;
  }
  const Eigen::VectorXd change = inverse.cwiseProduct(estimate.value - reference_);
  estimate.value -= sigmas_.cwiseProduct(left * (left.transpose() * change));
  estimate.spread -= sigmas_.asDiagonal() * (left * (left.transpose() * (inverse.asDiagonal() * estimate.spread)));
  return estimate;
}

void OwnEstimates::keepPlausible(OwnEstimate& estimate) const {
  const Eigen::ArrayXd start = reference_.cwiseQuotient(sigmas_).array(),
                       most = (start.abs() + 1).max(threshold::farthest);
  const auto isPlausible = [&](const OwnEstimate& one) {
    return (one.value.cwiseQuotient(sigmas_).array().abs() <= most).all();
  };
  OwnEstimate kept = estimate;
  Eigen::Index left = 0;
  while (left < sigmas_.size() && !isPlausible(kept)) {
    ++left;
    kept = leaveToPriors(directions_.rightCols(left), shares_.tail(left), estimate);
  }
  if (left > 0) {
    const Eigen::VectorXd missing = (1 - shares_.tail(left).array()).max(0).sqrt();
    const Eigen::Index before = kept.spread.cols(), coefficients = kept.coefficientSpread.rows();
    kept.spread.conservativeResize(Eigen::NoChange, before + left);
    kept.spread.rightCols(left) = sigmas_.asDiagonal() * directions_.rightCols(left) * missing.asDiagonal();
    kept.coefficientSpread.conservativeResizeLike(Eigen::MatrixXd::Zero(coefficients, before + left));
    estimate = std::move(kept);
  }
}

} // namespace naocal
