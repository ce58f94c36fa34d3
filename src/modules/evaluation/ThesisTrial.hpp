#pragma once

#include "evaluation/ThesisExperiment.hpp"

#include <cstdint>

namespace naocal {

/// How a calibration ended (algorithms 2 to 4), tested in this order.
enum class ThesisStatus { solverFailure, noConvergence, localMinimum, success };

/// What a solver made of an error set.
struct ThesisSolution {
  bool solved = false;                         // the solver ended by itself, in a possible state
  double rms = 0;                              // of the corners at its offsets, per axis [px]
  double rmsTolerance = 0;                     // twice what the true offsets leave, and a pixel [px]
  Eigen::VectorXd errors;                      // of the offsets, per joint of the stage [rad]
  ThesisStatus status(double tolerance) const; // of each offset [rad]
};

/// Error sets of one setting, one after the other: the same number gives the same offsets in all settings, and the same
/// measurements for all solvers.
class ThesisTrial {
public:
  /// `pixel`: corner noise where there is any [px].
  ThesisTrial(const ThesisExperiment& stage, const ThesisSetting& setting, double pixel);

  void draw(std::uint64_t seed, std::size_t number);
  ThesisSolution solve(ThesisSolver solver);

  /// Largest offset errors [rad] that an efficient estimator would make on this set: draws of N(0, H^-1), H our
  /// solver's information at the true offsets, the prior of `naocal solve` included (Cramer-Rao limit; zero without
  /// noise). Rounding errors count as normal ones of the same variance.
  std::vector<double> drawLimitErrors(std::size_t draws);

  const Measurements& measurements() const { return taken_; }
  Eigen::VectorXd offsets() const { return truth_.head(joints()); } // the true ones, per joint of the stage [rad]
  const Noise& noise() const { return noise_; }

private:
  Eigen::Index joints() const { return static_cast<Eigen::Index>(stage_.joints().size()); }

  const ThesisExperiment& stage_;
  ThesisSetting setting_;
  Noise noise_;
  Model plainModel_, ourModel_;
  Measurements taken_;
  Eigen::VectorXd truth_;                             // of the stage's model
  std::optional<Residuals> pixels_, whitened_, flat_; // as ThesisSearch has them
  double numbers_ = 0;                                // measured: two per corner
  double rmsAtTruth_ = 0;                             // [px]
  std::optional<RandomStream> starts_, limits_;
};

} // namespace naocal
