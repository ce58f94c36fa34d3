#pragma once

#include "evidence/PoseResiduals.hpp"
#include "evidence/ScoreProblem.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

namespace naocal {

/// The model without any candidate at one level of noise: how likely residuals are under it.
class ModelAlone {
public:
  ModelAlone(const ScoreProblem& problem, const Noise& noise);

  /// Of each set of residuals (column): -2 ln of the model's restricted likelihood up to a constant, and chi2 up to a
  /// constant; both constants are the same at all levels.
  struct Outcome {
    Eigen::RowVectorXd deviance, chi2;
    Eigen::MatrixXd own; // L^-1 times the scores of the own unknowns
  };
  Outcome operator()(const PoseResiduals& residuals, const Eigen::VectorXd& priorScore) const;

  /// Of a pose whose deflections have the covariance R R^T:
  ///   J^T Sigma^-1 J = (J^T J - (B J)^T (B J)) / pixel^2,   B = L^-1 M^T, M = J_t R / pixel, L L^T = I + M^T M.
  /// A half, for the product B^T B loses the digits that sharp corners and loose joints need.
  struct Whitener {
    Eigen::MatrixXd half;     // B, or what has as few rows as J and the same product
    Eigen::MatrixXd unknowns; // B J_x / pixel, of the unknowns and candidates
  };
  const Whitener& whitener(std::size_t pose) const { return whiteners_[pose]; }
  /// Of the own unknowns' information, priors included: L L^T.
  const Eigen::LLT<Eigen::MatrixXd>& factor() const { return factor_; }
  const ScoreProblem& problem() const { return problem_; }
  const Noise& noise() const { return noise_; }

private:
  /// What deflections take of the own unknowns' information.
  struct Taken {
    Eigen::MatrixXd information;
    double logDeterminant = 0;
  };
  void takeDeflections(std::size_t pose, Taken& taken);

  const ScoreProblem& problem_;
  Noise noise_;
  std::vector<Whitener> whiteners_;
  double logDeterminant_ = 0;
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

} // namespace naocal
