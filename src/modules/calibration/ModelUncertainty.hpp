#pragma once

#include "calibration/CandidateTests.hpp"
#include "calibration/Fit.hpp"
#include "estimation/Model.hpp"
#include "inference/ModelWindow.hpp"
#include "inference/WideModel.hpp"

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// The model with priors widened where the fit requires it: an effect added to the base model gets
/// `widestWidth` if that raises the likelihood of the measurements. A prior that is too narrow would shrink the
/// effect, and an alias would absorb the rest. Absent if no prior changes. `unknowns`, `variances`: of the fit, priors
/// included.
std::optional<Model> widenPriors(const Model& model, const Eigen::VectorXd& unknowns, const Eigen::VectorXd& variances);

/// As above, at a fit of the model.
std::optional<Model> widenPriors(const Model& model, const Fit& fit);

/// The analysis of missing effects for a fitted model.
struct MissingEffectAnalysis {
  NoiseLevels levels;        // estimated under the widest model
  Fit fit;                   // of the model as given, from which the search started; in the end, at `levels`
  std::vector<Term> effects; // named effects of the likeliest explanation
  Model larger;              // the model with `effects` in place of those that the user added to the base model
  Fit largerFit;             // fit of `larger`; equals `fit` without effects
  Model own;                 // the model without either: its unknowns are the window's own unknowns
  ModelWindow window;        // linearised at `largerFit`
  std::shared_ptr<const WideModel> wide; // what `window` is a window of
  std::vector<std::string> names;        // name of the effect or curve, per group of the window

  /// Whether an effect is missing that is no deflection of a joint, while joints do not scatter to their limit.
  bool lacksMoreThanScatter() const;
};

/// Estimates noise levels under the widest model and the window of explanations. Relinearises at the likeliest
/// explanation until it no longer changes, since a linearisation far from a large effect underestimates it. Effects
/// that the user added to the base model compete with all others, so an alias may replace them.
///
/// `fit`: where the search starts; if its loss is quadratic, no measurement loses weight before an explanation is
/// found.
///
/// Searches for a window of likely models, named effects and free curves alike, to average the estimates over them.
/// Criterion: posterior probability, from linearised Bayes factors and the number of candidates (`ModelWindow`). In
/// contrast, the diagnosis' stepwise selection searches for one model to report and requires that each effect lowers
/// the held-out error. `repeats`: how poses were repeated; absent: joint noise levels stay as in `noise`.
MissingEffectAnalysis analyseMissingEffects(const Measurements& measurements, const Model& model, const Fit& fit,
                                            const Noise& noise, const std::optional<RepeatInfo>& repeats,
                                            const CalibrationOptions& options);

/// Description length of all measurements by the likeliest explanation: -2 ln of their probability and the
/// explanation's, up to a constant of the measurements. By Laplace's method at the minimum of `larger`, with a loss
/// that gives each corner and reading the price of an accident at most (`Loss`).
double describe(const Measurements& measurements, const MissingEffectAnalysis& explained);

/// Name of a group of columns: "elasticity@LKneePitch", or for a curve "LKneePitch over q".
std::string formatGroup(const WideModel& wide, const Robot& robot, std::size_t group);

/// Sets a result's p-value, and what the tests of its fit say of missing effects.
void fillCompleteness(const CandidateTests& tests, const Robot& robot, CalibrationResult& result);

/// Effects that the user added to the base model; explanations may replace them.
std::vector<Term> addedEffects(const Model& model);

} // namespace naocal
