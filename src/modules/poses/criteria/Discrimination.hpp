#pragma once

#include "diagnosis/Diagnosis.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// An effect that may be there, and what is believed about it.
struct Hypothesis {
  std::string label;         // "elasticity@LKneePitch"
  Eigen::VectorXd size;      // of its unknowns if it is there [the unknowns' units]
  Eigen::VectorXd plausible; // how large they may be: their priors' sigmas
  double odds = 0;           // that it is the one, or is there at all; of all suspects together 1
};

/// What captures leave open, best answered by further poses.
struct ModelAmbiguity {
  std::vector<Hypothesis> suspects; // the likeliest first; none: nothing is open
  bool rivals = false;              // which one of the suspects is there? else: is each of them there at all?
  std::vector<std::string> with;    // what the model has beyond the base: none of the suspects
  std::vector<std::string> without;
  std::vector<Effect> effects; // all that suspects and model are named by
  std::string why;             // "tells elasticity@LKneePitch from backlash@LKneePitch"; empty: there is no question
  std::string whyNone;         // in words, where there is no question that poses could answer
};

/// The first of these that a diagnosis leaves open: which effect of a class that its captures cannot tell apart is
/// there; whether a curve that no effect describes is what its best rival of the catalogue says; whether candidates are
/// there that the captures hardly test. Odds are exp(evidence / 2), evidence = 2 ln of the Bayes factor.
ModelAmbiguity findAmbiguity(const Diagnosis& diagnosis, const Robot& robot, const DiagnosisOptions& asked);

/// 2 ln Bayes factors as probabilities: exp(evidence / 2), together 1.
std::vector<double> posteriorProbabilities(const std::vector<double>& evidence);

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
  Discrimination(const ModelAmbiguity& question, Eigen::Index own);

  /// lambda of each ordered pair of rivals, or of each suspect, in an order of its own.
  Eigen::VectorXd misfits(const Eigen::MatrixXd& hessian) const;

  /// What further captures promise: sum over pairs of odds_j odds_k (1 - exp(-(after - before) / 8)); the exponential
  /// bounds the chance that the pair is still confused.
  double expectedGain(const Eigen::VectorXd& before, const Eigen::VectorXd& after) const;

  /// By how much the misfits grow on average: exp of the mean of ln(after / before), weighted by the pairs' odds.
  double growthFactor(const Eigen::VectorXd& before, const Eigen::VectorXd& after) const;

private:
  struct Pair {
    std::size_t one;
    std::optional<std::size_t> other;
    double weight; // all together 1
  };
  const ModelAmbiguity& question_;
  Eigen::Index own_;
  std::vector<Eigen::Index> first_; // column of each suspect behind the own ones
  std::vector<Pair> pairs_;
};

} // namespace naocal
