#pragma once

#include "poses/OpenQuestion.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace naocal {

/// How surely suspects are told apart, or seen, by what some captures tell.
///
///   V    = H_cc - H_co H_oo^-1 H_oc          information about the suspects' unknowns c, the model's own o eliminated
///   I_jk = V_jj - V_jk (V_kk + 1/plausible^2)^-1 V_kj        what k cannot imitate of j; V_jj where j has no rival
///   lambda_jk = size_j^T I_jk size_j         misfit (chi2) that is left when j is there and the model has k instead
///
/// (T-optimality: Atkinson and Fedorov 1975; the odds as weights: Box and Hill 1967.)
class Discrimination {
public:
  /// `model`'s own unknowns come first, then those of the suspects in their order.
  Discrimination(const OpenQuestion& question, Eigen::Index own);

  /// lambda of each ordered pair of rivals, or of each suspect, in an order of its own.
  Eigen::VectorXd misfits(const Eigen::MatrixXd& hessian) const;

  /// What further captures promise: sum over pairs of odds_j odds_k (1 - exp(-(after - before) / 8)); the exponential
  /// bounds the chance that the pair is still confused.
  double gain(const Eigen::VectorXd& before, const Eigen::VectorXd& after) const;

  /// By how much the misfits grow on average: exp of the mean of ln(after / before), weighted by the pairs' odds.
  double growth(const Eigen::VectorXd& before, const Eigen::VectorXd& after) const;

private:
  struct Pair {
    std::size_t one;
    std::optional<std::size_t> other;
    double weight; // all together 1
  };
  const OpenQuestion& question_;
  Eigen::Index own_;
  std::vector<Eigen::Index> first_; // column of each suspect behind the own ones
  std::vector<Pair> pairs_;
};

} // namespace naocal
