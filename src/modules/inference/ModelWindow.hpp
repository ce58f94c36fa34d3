#pragma once

#include "inference/ScoreTest.hpp"
#include "math/StudentMixture.hpp"

#include <compare>
#include <cstddef>
#include <set>
#include <vector>

namespace naocal {

inline constexpr std::size_t mostMembers = 4; // of an explanation: every choice of their widths is a model

/// A group of columns of the score problem (index `group`) in a model: all columns of an effect, or the first `count`
/// of a smooth curve.
struct WindowMember {
  std::size_t group = 0;
  Eigen::Index count = 0;

  auto operator<=>(const WindowMember&) const = default;
};

/// One explanation of the captures: the model's own unknowns plus some effects and curves, each with a prior width.
struct WindowModel {
  std::vector<WindowMember> members;
  std::vector<double> widths;        // of each member's prior, in units of what is plausible (`plausibleWidths`)
  double cost = 0;                   // -2 ln of its posterior probability, up to a constant: 0 for the model alone
  double weight = 0;                 // its share among the window's models
  Eigen::VectorXd unknowns;          // own unknowns, refitted with the members (`OwnEstimates`)
  Eigen::MatrixXd spread;            // F: their covariance is `ModelWindow::covariance` + F F^T
  Eigen::VectorXd sizes;             // coefficients of the members' columns, concatenated [the columns' units]
  Eigen::MatrixXd sizeSpread;        // R: u of covariance 1 moves the unknowns by F u and the sizes by R u
  std::vector<Eigen::Index> columns; // of `sizes`, among those of the problem
};

/// An effect that the likeliest model lacks, and what it does to the own unknowns where it stays unnoticed: their bias
/// is `biases` v with |v| <= 1. Its sizes c, in units of what is plausible, then lie within the ellipsoid
///   c^T (S / lambda + I / 9) c <= 1,
/// S their information in the likeliest model, lambda the noncentrality that a test of all effects (5 % by Bonferroni)
/// detects with 80 % power, and 9 = 3^2: beyond three sigma a size is implausible. (RAIM's slope: Brown and Chin 1998;
/// minimal detectable bias: Baarda 1968.)
struct UndetectedEffect {
  std::size_t group;
  Eigen::MatrixXd biases;
  Eigen::MatrixXd sizes; // the effect's sizes themselves are this v [the columns' units]
  Eigen::MatrixXd taken; // the sizes of the likeliest model's columns change by this v [the columns' units]
};

/// Posterior of the own unknowns under model uncertainty: Bayesian model averaging over a window of models.
///
/// The cost of a model m is D_m = -2 ln B_m + 2 ln K per effect (K: number of candidate effects; for a curve: number of
/// curves times degrees, plus `threshold::unnamed`), B_m as in `computeBayesFactor` over `plausibleWidths`, each member
/// with a width of its own: where one unknown of an effect is beyond plausible, another that the captures do not
/// determine may be, too. Each choice of widths counts as a model. Starting without members, the search adds the group
/// that lowers D most until none does. After each addition it drops members whose removal does not raise D (an alias
/// leaves when the true effect joins). The window (Occam's window) is the model found, every removal, every swap of one
/// member, and every addition (Madigan and Raftery, JASA 89 (1994) 1535; Hoeting et al., Statistical Science 14 (1999)
/// 382), weighted by exp(-D_m / (2 misfit)) (quasi-likelihood: Burnham and Anderson, Model selection, 2002,
/// section 2.5), with estimates at that misfit (`OwnEstimates`):
///   mean = sum w_m unknowns_m,   variance = sum w_m [C_m + (unknowns_m - mean)^2].
/// The first `expected` effects are known to be present without their identity being known; they cost no 2 ln K.
struct ModelWindow {
  std::vector<WindowModel> models;  // by decreasing weight; relative weights below 1e-5 are dropped
  double misfit = 1;                // chi2 / freedom of the likeliest model, at least 1: misfit that no model explains
  double freedom = 0;               // degrees of freedom of the likeliest model
  Eigen::MatrixXd covariance;       // of the own unknowns, without members
  Eigen::VectorXd mean, variance;   // posterior of the own unknowns
  std::vector<double> groupWeights; // posterior inclusion probability per group of the problem
  std::vector<UndetectedEffect> undetected;
  double unnamedGain = 0; // decrease of the cost by the curves of the likeliest model

  /// What each model says of a linear function of the own unknowns and of all columns' coefficients: weight, value,
  /// standard error.
  std::vector<StudentMixture::Part> along(const Eigen::VectorXd& own, const Eigen::VectorXd& columns) const;
};

/// Costs of two explanations at one noise level, as `WindowModel::cost` but relative to -2 ln likelihood at the
/// linearisation point, which holds the fitted effects at their fitted sizes.
struct ExplanationCosts {
  double fitted = 0;    // the effects with sizes at the linearisation point, at these sizes; 0 without any
  double likeliest = 0; // the likeliest model found by the search
};
ExplanationCosts costExplanations(const MeasuredTests& measured);

/// Named effects that explain together.
struct LikelyEffects {
  std::vector<std::size_t> groups; // ascending
  double evidence = 0;             // 2 ln(posterior odds) against that nothing is missing
};
/// Explanations by named effects alone that are likelier than that nothing is missing, likeliest first. Their sizes'
/// choices count together. `excluded`: effects that no explanation may have.
std::vector<LikelyEffects> listLikelyEffects(const MeasuredTests& measured, const std::set<std::size_t>& excluded = {});

/// Searches the window. `expected`: as above. Models have at most `mostMembers`; the window contains at least the
/// likeliest. Throws InputError if its cost or the estimates are not finite.
ModelWindow searchModelWindow(const MeasuredTests& measured, std::size_t expected = 0);

} // namespace naocal
