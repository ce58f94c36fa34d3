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

  /// Of a pose whose deflections J_t have the covariance D = R R^T:  J^T Sigma^-1 = J^T - J^T J_t H^T H J_t^T, with
  /// H = L^-1 R^T and L L^T = I + R^T J_t^T J_t R (J in units of the pixel noise). Halves, for the product H^T H loses
  /// the digits that sharp corners and loose joints need.
  struct Whitener {
    Eigen::MatrixXd half;     // H
    Eigen::MatrixXd unknowns; // H J_t^T J_x, of the unknowns and candidates
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
