#pragma once

#include "evaluation/thesis/SoleCamera.hpp"
#include "math/Sampling.hpp"

#include <Eigen/Core>
#include <vector>

namespace naocal {

/// Floor points in a picture, as a program sees them that computes in single precision.
struct ProgramPicture {
  Eigen::VectorXf readings; // one per joint of the camera's chain [rad]
  Eigen::Matrix2Xf points;  // on the floor, in the sole's frame [m]
  Eigen::Matrix2Xf pixels;  // measured [px]
};

/// Every picture's points as often as `copies` features coincide in them: they have equal predictions, so their sum of
/// squares is that of the mean measurement, `copies` times, plus a constant, `scatter` [px^2], which the stop rules
/// see.
struct ProgramMeasurements {
  std::vector<ProgramPicture> pictures;
  double copies = 1, scatter = 0;
};

/// Estimated errors of the joints [rad], and whether the search ended because it ran out of evaluations.
struct ProgramEstimate {
  Eigen::VectorXd errors;
  bool ranOut = false;
};

/// Levenberg-Marquardt in the numeric form of the thesis's own program, for the errors e of joints, true angle =
/// reading
/// + e: float residuals (measured - predicted, unit weights), central differences with steps of sqrt(float epsilon) |e|
/// = 3.5e-4 |e|, MINPACK's lmder as Eigen ports it (unsupported/NonLinearOptimization) with its default stop rules:
/// relative falls of the cost and relative steps below 3.5e-4, or 400 evaluations of the residuals. Of its 14
/// parameters, head and both legs, six have no influence but take part in the differences: every iteration costs 29
/// evaluations, so that a search ends after at most 14 iterations, wherever it is.
class ProgramSolver {
public:
  /// `names`: joints of the chain. Keeps references.
  ProgramSolver(const SoleCamera<float>& camera, const std::vector<std::string>& names,
                const ProgramMeasurements& measurements)
      : camera_{camera}, names_{names}, measurements_{measurements} {}

  /// From zero; with 100 random starts if the estimate leaves +-6.5 degrees.
  ProgramEstimate solve(RandomStream& starts) const;
  /// From zero and 100 random starts, the best one.
  ProgramEstimate solveFromRandomStarts(RandomStream& starts) const;

private:
  /// End of a search: all parameters [rad], sum of squares [px^2].
  struct Minimum {
    Eigen::VectorXf errors;
    float cost = 0;
    bool ranOut = false;
  };
  Minimum minimum(Eigen::VectorXf start) const;
  Minimum bestOfRandomStarts(Minimum best, RandomStream& starts) const;
  ProgramEstimate estimate(const Minimum& best) const;

  const SoleCamera<float>& camera_;
  const std::vector<std::string>& names_;
  const ProgramMeasurements& measurements_;
};

} // namespace naocal
