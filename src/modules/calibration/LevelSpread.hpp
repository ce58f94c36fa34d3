#pragma once

#include "estimation/Residuals.hpp"
#include "inference/NoiseLevels.hpp"

#include <Eigen/Core>
#include <vector>

namespace naocal {

/// Minimum under another noise level, extrapolated from a linearisation nearby, and its covariance.
struct LinearMinimum {
  Eigen::VectorXd step; // from the unknowns of the linearisation
  Eigen::MatrixXd covariance;
};
LinearMinimum solveLinearized(const Residuals::Linear& linear, const Eigen::VectorXd& unknowns,
                              const Eigen::VectorXd& sigmas, const Noise& noise);

/// Variance of an estimate whose noise levels are uncertain: few poses hardly tell how joints scatter.
struct UncertainVariance {
  double mean = 0;           // over the possible noise levels
  double relativeSpread = 0; // Var(variance) / mean^2
  double widening = 1;       // mean, relative to the variance at the most likely levels

  /// The Student's t distribution of equal variance and kurtosis as a normal one of this variance:
  /// nu = 4 + 2 / relativeSpread, at most a million.
  double freedom() const;
};

/// The unknowns' covariance at every possible noise level. `misfit`: that no model explains (`temperPrecision`).
class LevelSpread {
public:
  LevelSpread(const Residuals::Linear& linear, const Eigen::VectorXd& unknowns, const Eigen::VectorXd& sigmas,
              const NoiseLevels& levels, double misfit);

  Eigen::Index size() const { return likeliest_.rows(); } // number of unknowns
  /// Of a linear function of the unknowns. `moves`: whether its estimate's shift from level to level counts as
  /// variance.
  UncertainVariance along(const Eigen::VectorXd& direction, bool moves) const;

private:
  struct Level {
    double weight;
    LinearMinimum minimum;
  };
  std::vector<Level> levels_;
  Eigen::MatrixXd likeliest_; // covariance
};

} // namespace naocal
