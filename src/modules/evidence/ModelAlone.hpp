#pragma once

#include "evidence/ScoreProblem.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

namespace naocal {

/// The model without any candidate at one level of noise: how likely scores are under it.
class ModelAlone {
public:
  ModelAlone(const ScoreProblem& problem, const Noise& noise);

  /// Of each set of scores (column): -2 ln of the model's restricted likelihood up to a constant, and chi2 up to a
  /// constant; both constants are the same at all levels.
  struct Outcome {
    Eigen::RowVectorXd deviance, chi2;
    Eigen::MatrixXd own; // L^-1 times the scores of the own unknowns
  };
  Outcome operator()(const PoseScores& scores, const Eigen::VectorXd& priorScore) const;

  struct Whitener {           // of a pose, P = S - S (S + (J_t^T J_t)^-1)^-1 S:  J^T Sigma^-1 = J^T - J^T J_t P J_t^T
    Eigen::MatrixXd inner;    // P
    Eigen::MatrixXd unknowns; // J_x^T J_t P
  };
  const Whitener& whitener(std::size_t pose) const { return whiteners_[pose]; }
  /// Of the own unknowns' information, priors included: L L^T.
  const Eigen::LLT<Eigen::MatrixXd>& factor() const { return factor_; }
  const ScoreProblem& problem() const { return problem_; }
  const Noise& noise() const { return noise_; }

private:
  const ScoreProblem& problem_;
  Noise noise_;
  std::vector<Whitener> whiteners_;
  double logDeterminant_ = 0;
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

} // namespace naocal
