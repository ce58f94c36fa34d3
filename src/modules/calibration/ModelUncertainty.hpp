#pragma once

#include "calibration/Calibration.hpp"
#include "calibration/Fit.hpp"
#include "estimation/Model.hpp"
#include "inference/ModelWindow.hpp"
#include "inference/WideModel.hpp"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// The model with priors as wide as a fit asks for: an effect that was added to the base gets the wider of the
/// plausible widths (`plausibleWidths`) where that makes what was measured likelier. Else a prior that expects
/// something smaller draws it towards zero, and a twin takes the rest. Absent where no prior need be wider. `unknowns`,
/// `variances`: of the fit, its priors included.
std::optional<Model> addPriors(const Model& model, const Eigen::VectorXd& unknowns, const Eigen::VectorXd& variances);

/// A model's fit put to the question what may be missing.
struct Explained {
  NoiseLevels levels;             // under the widest model
  Fit fit;                        // of the model as it is, at these levels
  std::vector<Term> effects;      // with a name, of the likeliest explanation
  Model larger;                   // with them in place of those that were added to the base
  Fit largerFit;                  // of that; `fit` where there are none
  Model own;                      // without either: the window's own unknowns
  ModelWindow window;             // about `larger`
  std::vector<std::string> names; // per group of the window: what its effect or curve is called
  double pValue = 1;              // that the model as it is lacks nothing (`Evidence`)
  bool matters = false;           // what shows moves corners by more than a lens is known to
};

/// Noise levels under the widest model, and the window of explanations, linearised anew where the likeliest one leads
/// until it stays the same: from far a linear model of a large effect falls short. Effects that a person added to the
/// base are members like any other: a twin may be there in their place.
/// `repeats`: how poses were repeated; absent: the joints' levels stay as in `noise`.
Explained explain(const Measurements& measurements, const Model& model, const Fit& fit, const Noise& noise,
                  const std::optional<RepeatInfo>& repeats, const CalibrationOptions& options);

/// Fills a result's averages, explanations, misfit left, scatter and p-value.
void describe(const Explained& explained, const Model& model, CalibrationResult& result);

} // namespace naocal
