#pragma once

#include "evaluation/ThesisExperiment.hpp"

#include <cstdint>

namespace naocal {

/// Outcome of a calibration (algorithms 2 to 4), tested in this order.
enum class ThesisStatus { solverFailure, noConvergence, localMinimum, success };

/// A solver's result on an error set.
struct ThesisSolution {
  bool solved = false;                         // converged to a valid state
  double rms = 0;                              // of the corners at the estimated offsets, per axis [px]
  double rmsTolerance = 0;                     // twice the rms at the true offsets, plus 1 [px]
  Eigen::VectorXd errors;                      // of the offsets, per joint of the experiment [rad]
  ThesisStatus status(double tolerance) const; // tolerance: of each offset [rad]
};

/// Error sets of one setting: the same number gives the same offsets in all settings, and the same measurements for all
/// solvers.
class ThesisTrial {
public:
  /// `pixel`: corner noise, if present, 1 sigma [px].
  ThesisTrial(const ThesisExperiment& stage, const ThesisSetting& setting, double pixel);

  void draw(std::uint64_t seed, std::size_t number);
  ThesisSolution solve(ThesisSolver solver);

  /// Largest offset errors [rad] of an efficient estimator on this set: draws of N(0, H^-1), H being our solver's
  /// information at the true offsets, including the prior of `naocal solve` (Cramer-Rao limit; zero without noise).
  /// Rounding errors are treated as normal with the same variance.
  std::vector<double> drawLimitErrors(std::size_t draws);

  const Measurements& measurements() const { return taken_; }
  Eigen::VectorXd offsets() const { return truth_.head(joints()); } // true values, per joint of the experiment [rad]
  const Noise& noise() const { return noise_; }

private:
  Eigen::Index joints() const { return static_cast<Eigen::Index>(stage_.joints().size()); }

  const ThesisExperiment& stage_;
  ThesisSetting setting_;
  Noise noise_;
  Model plainModel_, ourModel_;
  Measurements taken_;
  Eigen::VectorXd truth_;                             // values of the experiment model's unknowns
  std::optional<Residuals> pixels_, whitened_, flat_; // as in ThesisSearch
  double numbers_ = 0;                                // measured values: two per corner
  double rmsAtTruth_ = 0;                             // [px]
  std::optional<RandomStream> starts_, limits_;
};

} // namespace naocal
