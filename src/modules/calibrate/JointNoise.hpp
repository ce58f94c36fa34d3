#pragma once

#include "residuals/Residuals.hpp"

#include <Eigen/Core>
#include <vector>

namespace naocal {

/// -2 ln of the half-Cauchy prior of pose noise [rad], up to a constant, of 0.02 degrees: few poses hardly tell its
/// level (Gelman, Bayesian Analysis 1 (2006) 515).
double scatterPenalty(double level);

/// Levels of joint noise, and how sure they are.
struct JointNoise {
  Noise noise; // the levels to fit with
  struct Level {
    Noise noise;
    double weight = 0; // posterior probability; all levels' sum to 1
  };
  std::vector<Level> levels; // empty: the noise is taken as known
};

/// How poses were repeated.
struct Repeated {
  bool reapproached = false; // left and taken again
  bool restood = false;      // that, and by a robot that was put down anew besides
};

/// Encoder, pose and stance noise from what the unknowns leave over, by restricted likelihood (REML)
///   -2 l = sum_pose ln |Sigma_pose| + ln |H| + r^T Sigma^-1 (I - P) r
/// (Patterson and Thompson, Biometrika 58 (1971) 545). Pixel noise stays as given. The encoder's level stays too unless
/// poses were left and taken again, for only then do repeats show it, and never falls below the rounding of its steps;
/// the stance's is zero unless poses were taken again by a robot put down anew, too.
/// Few poses hardly tell the pose level, often not even whether there is one: it is therefore integrated over, with a
/// half-Cauchy prior of 0.02 degrees (Gelman, Bayesian Analysis 1 (2006) 515), instead of being believed at its peak.
JointNoise jointNoise(const Residuals::Linear& linear, const Eigen::VectorXd& unknowns, const Eigen::VectorXd& sigmas,
                      const Noise& start, const Repeated& repeated);

/// The minimum under another noise level, from the linearisation at a near one: where it lies and its covariance.
struct LinearMinimum {
  Eigen::VectorXd step; // from the linearisation's unknowns
  Eigen::MatrixXd covariance;
};
LinearMinimum linearMinimum(const Residuals::Linear& linear, const Eigen::VectorXd& unknowns,
                            const Eigen::VectorXd& sigmas, const Noise& noise);

} // namespace naocal
