#pragma once

#include "diagnose/ScoreProblem.hpp"

#include <cstdint>
#include <vector>

namespace naocal {

/// What the captures say about one group of columns.
struct GroupEvidence {
  double likelihoodRatio = 0; // fall of -2 ln likelihood when it is added, pose noise estimated with and without it
  double pValue = 1;          // of that ratio by chi2, as if it were the only candidate
  double bayes = 0;           // 2 ln of the Bayes factor against the model alone, coefficients ~ N(0, plausible^2)
  double level = 0;           // pose noise with it added [rad]
  double fall = 0;            // of chi2 at that level
  double keptFraction = 0;
  Eigen::Index freedom = 0;
  Eigen::VectorXd estimate;   // of its coefficients at that level, the model's own unknowns refitted (linearised)
  Eigen::MatrixXd covariance; // of that estimate
};

/// The verdict of numbers: is something missing, and what do the candidates explain.
struct Evidence {
  double level = 0;                  // pose noise of the model alone, by restricted likelihood [rad]
  double withoutScatter = 0;         // fall of -2 ln likelihood from no pose noise to that level
  std::vector<GroupEvidence> groups; // as in the problem
  double pValue = 1;                 // family-wise: how often pure noise shows a candidate at least as striking
  Eigen::MatrixXd information;       // of the candidate effects' unknowns, at the level that the best of them leaves
  double criticalP = 0;              // a single candidate's p-value below which the family-wise alarm is at 5 %
};

/// Profile likelihood ratios of all groups, pose noise estimated anew under each hypothesis, with the null distribution
/// of their largest by a parametric bootstrap of the linearised problem (`draws` times the same procedure on noise of
/// the level found; none when 0): the alarm's rate is then right for any number of poses and any correlation of
/// candidates. `levels` of pose noise are tried, ascending [rad]; where there are none, those of `poseLevels`.
Evidence evidenceOf(const ScoreProblem& problem, const Noise& noise, const std::vector<double>& levels = {},
                    Eigen::Index draws = 0, std::uint64_t seed = 1);

} // namespace naocal
