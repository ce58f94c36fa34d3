#pragma once

#include "calibrate/Fit.hpp"

namespace naocal {

/// chi2 = r^T Sigma^-1 r of all corners that count; dof = numbers measured - numbers learned.
struct Misfit {
  double chi2 = 0, dof = 0, pValue = 1;
  double scale = 1; // sqrt(chi2/dof) where the misfit is beyond doubt (p < 0.001)
};
Misfit misfitOf(const Fit& fit, const Eigen::VectorXd& sigmas);

/// All levels times a factor.
Noise scaled(const Noise& noise, double factor);

/// A fit's numbers with what they are worth: covariance = inverse Hessian of the whitened problem, priors included,
/// averaged over the levels of noise that are possible; 95 % intervals of the Student's t with that variance and
/// kurtosis.
CalibrationResult uncertain(const Measurements& measurements, const Model& model, const Fit& fit,
                            const JointNoise& noise, const Misfit& misfit);

} // namespace naocal
