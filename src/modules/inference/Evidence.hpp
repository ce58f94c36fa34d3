#pragma once

#include "inference/ScoreTest.hpp"
#include "inference/Thresholds.hpp"

#include <cstdint>
#include <vector>

namespace naocal {

/// What the captures say about one group of columns.
struct GroupEvidence {
  double likelihoodRatio = 0; // fall of chi2, -2 ln likelihood, when it is added
  double pValue = 1;          // of that ratio by chi2, as if it were the only candidate
  double bayes = 0;           // 2 ln of the Bayes factor against the model alone (`computeBayesFactor`)
  double keptFraction = 0;
  double movedPx = 0; // how far it moves predicted corners, rms, the own unknowns refitted; of likely effects and the
                      // likeliest curve only

  /// Large enough to matter: no lens and no detector of corners is known better than to 0.1 px.
  bool matters() const { return movedPx > threshold::negligiblePx; }
  Eigen::Index freedom = 0;
  Eigen::VectorXd estimate;   // of its coefficients, the model's own unknowns refitted (linearised)
  Eigen::MatrixXd covariance; // of that estimate
};

/// The verdict of numbers: is something missing, and what do the candidates explain.
struct Evidence {
  std::vector<GroupEvidence> groups; // as in the problem
  double pValue = 1;                 // family-wise: how often pure noise shows a candidate at least as striking
  Eigen::MatrixXd information;       // of the candidate effects' unknowns
  bool matters = false;              // a group that is beyond chance does, or none is likely
  double criticalP = 0;              // a single candidate's p-value below which the family-wise alarm is at 5 %
};

/// How large coefficients may be, in units of what is plausible: most often about that, sometimes four times as much.
/// One width alone names an effect of five sigma as its twin (a twin that is smaller explains it nearly as well), and
/// the offset that tells them apart with it.
struct PlausibleWidth {
  double width, odds;
};
constexpr PlausibleWidth plausibleWidths[] = {{1, 0.8}, {4, 0.2}};

/// 2 ln of the Bayes factor of coefficients ~ N(0, width^2), mixed over `plausibleWidths`, against none:
///   B(width) = |I + width^2 V|^-1/2 exp(s^T (V + width^-2)^-1 s / 2),   s, V their score and information in units of
/// what is plausible.
double computeBayesFactor(const Eigen::MatrixXd& information, const Eigen::VectorXd& score);

/// Score tests of all groups at one level of noise, with the null distribution of their largest by a parametric
/// bootstrap of the linearised problem (`draws` sets of pure noise; none when 0): the alarm's rate is then right for
/// any number of poses and any correlation of candidates.
Evidence computeEvidence(const ScoreProblem& problem, const Noise& noise, Eigen::Index draws = 0,
                         std::uint64_t seed = 1);

} // namespace naocal
