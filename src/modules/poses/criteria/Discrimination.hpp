#pragma once

#include "diagnosis/Diagnosis.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// A candidate effect and its assumed size.
struct Hypothesis {
  std::string label;         // "elasticity@LKneePitch"
  Eigen::VectorXd size;      // of its unknowns if present [units of the unknowns]
  Eigen::VectorXd plausible; // prior sigmas of its unknowns
  double odds = 0;           // probability that it is the one, or is present; sums to 1 over all suspects
};

/// An open question of a diagnosis that further poses can resolve.
struct ModelAmbiguity {
  std::vector<Hypothesis> suspects; // most likely first; empty: nothing is open
  bool rivals = false;              // true: which of the suspects is present; false: whether each is present
  std::vector<std::string> with;    // terms of the model beyond the base model, without the suspects
  std::vector<std::string> without;
  std::vector<Effect> effects; // definitions for the labels of suspects and model
  std::string why;             // "tells elasticity@LKneePitch from backlash@LKneePitch"; empty: no question
  std::string whyNone;         // reason, if poses cannot resolve anything; for display
};

/// The first open question of a diagnosis, in this order: which effect of an equivalence class is present; whether an
/// unexplained curve or its best rival in the catalogue is present; whether undecided, then untestable candidates are
/// present. Odds are exp(evidence / 2), evidence = 2 ln of the Bayes factor, at least 1 to 20 within an equivalence
/// class.
ModelAmbiguity findAmbiguity(const Diagnosis& diagnosis, const Robot& robot, const DiagnosisOptions& asked);

/// Probabilities from 2 ln Bayes factors: proportional to exp(evidence / 2), sum 1.
std::vector<double> posteriorProbabilities(const std::vector<double>& evidence);

/// Expected misfits by which given information distinguishes suspects from each other, or detects them.
///
///   V    = H_cc - H_co H_oo^-1 H_oc          information about the suspects' unknowns c, the model's own o eliminated
///   I_jk = V_jj - V_jk (V_kk + 1/plausible^2)^-1 V_kj        part of j that k cannot mimic; V_jj if j has no rival
///   lambda_jk = size_j^T I_jk size_j         remaining misfit (chi2) if j is present and the model has k instead
///
/// (T-optimality: Atkinson and Fedorov 1975; the odds as weights: Box and Hill 1967.)
class Discrimination {
public:
  /// `own`: number of the model's own unknowns, which come first, followed by those of the suspects in order.
  Discrimination(const ModelAmbiguity& question, Eigen::Index own);

  /// lambda of each ordered pair of rivals, or of each suspect, in internal order.
  Eigen::VectorXd misfits(const Eigen::MatrixXd& hessian) const;

  /// Expected gain of further captures: sum over pairs of odds_j odds_k (1 - exp(-(after - before) / 8)); the
  /// exponential bounds the probability that the pair is still confused.
  double expectedGain(const Eigen::VectorXd& before, const Eigen::VectorXd& after) const;

  /// Average growth of the misfits: exp of the mean of ln(after / before), weighted by the pairs' odds.
  double growthFactor(const Eigen::VectorXd& before, const Eigen::VectorXd& after) const;

private:
  struct Pair {
    std::size_t one;
    std::optional<std::size_t> other;
    double weight; // sum is 1
  };
  const ModelAmbiguity& question_;
  Eigen::Index own_;
  std::vector<Eigen::Index> first_; // first column of each suspect, after the own ones
  std::vector<Pair> pairs_;
};

} // namespace naocal
