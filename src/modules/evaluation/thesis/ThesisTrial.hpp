#pragma once

#include "evaluation/thesis/HeldOutPoses.hpp"
#include "evaluation/thesis/ProgramSolver.hpp"
#include "evaluation/thesis/ResidualMap.hpp"
#include "evaluation/thesis/ThesisExperiment.hpp"

#include <cstdint>
#include <memory>

namespace naocal {

/// Outcome of a calibration (algorithms 2 to 4), tested in this order.
enum class ThesisStatus { solverFailure, noConvergence, localMinimum, success };

/// A solver's result on an error set.
struct ThesisSolution {
  bool solved = false;                         // converged to a valid state
  double rms = 0;                              // of the corners at the estimated offsets, per axis [px]
  double rmsTolerance = 0;                     // twice the rms at the true offsets, plus 1 [px]
  Eigen::VectorXd errors;                      // of the offsets, per joint of the experiment [rad]
  std::optional<HeldOutError> heldOut;         // settings with held-out poses: decides over convergence instead of rms
  bool ranOut = false;                         // the program's search ended by its number of evaluations
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

  /// Whether a search with exact derivatives, started from a wrong solution, reaches the true offsets (0.001 degrees).
  bool reachesTruthFrom(const ThesisSolution& wrong) const;

  /// Adds the lengths of a solution's residuals by their points on the floor.
  void addResiduals(const ThesisSolution& solution, ResidualMap& map) const;

  const Measurements& measurements() const { return taken_; }
  Eigen::VectorXd offsets() const { return truth_.head(joints()); } // true values, per joint of the experiment [rad]
  const Noise& noise() const { return noise_; }

private:
  /// What the thesis's own program has beside the measurements: a camera in single precision, and held-out poses.
  struct Program {
    SoleCamera<float> camera;
    SoleCamera<double> exactCamera;
    std::vector<std::string> names; // of the joints
    ProgramMeasurements measurements;
    std::optional<HeldOutPoses> heldOut;
  };

  Eigen::Index joints() const { return static_cast<Eigen::Index>(stage_.joints().size()); }
  void drawTruth(std::uint64_t seed, std::size_t number);
  void readAsProgram(RandomStream& measuring);
  ProgramEstimate solveAsProgram(ThesisSolver solver);

  const ThesisExperiment& stage_;
  ThesisSetting setting_;
  Noise noise_;
  Model plainModel_, ourModel_;
  Measurements taken_;
  Eigen::VectorXd truth_;                             // values of the experiment model's unknowns
  std::optional<Residuals> pixels_, whitened_, flat_; // as in ThesisSearch
  double numbers_ = 0;                                // measured values: two per corner
  double rmsAtTruth_ = 0;                             // [px]
  double pixel_;                                      // corner noise, if present, 1 sigma [px]
  std::unique_ptr<Program> program_;                  // of settings like the program's
  std::optional<RandomStream> starts_, limits_;
};

} // namespace naocal
