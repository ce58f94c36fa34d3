#pragma once

#include "inference/ScoreTest.hpp"
#include "inference/Thresholds.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace naocal {

/// Evidence for one group of columns.
struct GroupEvidence {
  double likelihoodRatio = 0; // decrease of chi2 (-2 ln likelihood) when the group is added
  double pValue = 1;          // p-value of the ratio under chi2, as if the group were the only candidate
  double bayes = 0;           // 2 ln(Bayes factor) against the model without candidates (`computeBayesFactor`)
  double keptFraction = 0;    // share of the group's information that the own unknowns do not absorb
  double movedPx = 0; // displacement of predicted corners [px], rms, own unknowns refitted; computed for likely effects
                      // and the likeliest curve only

  /// Whether the displacement exceeds 0.1 px, the accuracy of lens models and corner detectors.
  bool matters() const { return movedPx > threshold::negligiblePx; }
  Eigen::Index freedom = 0;
  Eigen::VectorXd estimate;   // linearised estimate of the coefficients, own unknowns refitted
  Eigen::MatrixXd covariance; // covariance of `estimate`
};

/// Overall evidence: whether anything is missing, and what each candidate explains.
struct Evidence {
  std::vector<GroupEvidence> groups; // in the problem's order
  double pValue = 1;                 // family-wise: probability that pure noise shows a candidate at least as striking
  Eigen::MatrixXd information;       // projected information of the candidate effects' unknowns
  bool matters = false;              // whether a significant group exceeds `negligiblePx`, or no group is likely
  std::optional<std::size_t> likeliest; // group with the largest Bayes factor, if that is above zero
  double criticalP = 0;                 // p-value of a single candidate at which the family-wise alarm rate is 5 %
};

/// Prior scale of coefficients in units of `plausible`, with its prior probability.
struct PriorWidth {
  double width, odds;
};

/// Usually what is plausible, sometimes four times as much, and often far less, as trackers and cameras see effects of
/// a sixteenth of it. With a single width, an effect of five sigma is attributed to a smaller alias that explains it
/// nearly as well, together with the offset that distinguishes the two. Without the small ones, each of the six
/// unknowns of a link's geometry costs 2 ln(plausible size / standard error) of evidence: a tilted axis that explains
/// half is named instead, or nothing, and offsets that such an effect shifts are called certain. Odds of 0.2 for the
/// smallest would name causes of misfits that are far below the noise.
constexpr PriorWidth usualWidth{1, 0.55}, widestWidth{4, 0.2};
constexpr PriorWidth plausibleWidths[] = {usualWidth, widestWidth, {1.0 / 4, 0.2}, {1.0 / 16, 0.05}};

/// 2 ln(Bayes factor) of coefficients ~ N(0, width^2), mixed over `plausibleWidths`, against zero coefficients:
///   B(width) = |I + width^2 V|^-1/2 exp(s^T (V + width^-2)^-1 s / 2),
/// with s, V the score and information in units of `plausible`.
double computeBayesFactor(const Eigen::MatrixXd& information, const Eigen::VectorXd& score);

/// Score tests of all groups at one noise level. The null distribution of the smallest p-value comes from a parametric
/// bootstrap of the linearised problem (`draws` sets of pure noise; 0: no bootstrap), so that the false-alarm rate
/// holds for any number of poses and any correlation between candidates.
///
/// Without pose noise, the bootstrap is conditional on the side of the boundary on which the data estimate that level
/// (`isPoseNoiseAtBoundary`): data at zero are compared only with draws at zero, usually two thirds of them. An
/// estimate at the boundary of its range is the mixture of a point mass and a continuous part (Self and Liang, JASA 82
/// (1987) 605), and a bootstrap at the estimated level does not reproduce it (Andrews, Econometrica 68 (2000) 399):
/// data with more misfit than usual get a level above zero, so those at zero have less than unconditional draws, and
/// their p-values would be too large. Above zero, draws are unconditional, and p-values near the boundary are a little
/// small. With fewer than 20 draws left, all are compared.
Evidence computeEvidence(const MeasuredTests& measured, Eigen::Index draws = 0, std::uint64_t seed = 1);

} // namespace naocal
