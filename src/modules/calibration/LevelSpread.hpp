#pragma once

#include "estimation/Residuals.hpp"
#include "inference/NoiseLevels.hpp"

#include <Eigen/Core>
#include <vector>

namespace naocal {

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
  /// Minimum at one level, extrapolated from the linearisation.
  struct Minimum {
    Eigen::VectorXd step; // from the unknowns of the linearisation
    Eigen::MatrixXd covariance;
  };
  struct Level {
    double weight;
    Minimum minimum;
  };
  std::vector<Level> levels_;
  Eigen::MatrixXd likeliest_; // covariance
};

} // namespace naocal
