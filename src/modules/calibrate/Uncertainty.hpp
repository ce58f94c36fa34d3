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

/// A fit's numbers with what they are worth: covariance = inverse Hessian of the whitened problem, priors included;
/// 95 % intervals with Student's t, whose degrees of freedom follow from how sure the noise levels are (Satterthwaite,
/// Biometrics Bulletin 2 (1946) 110): nu = 2 v^2 / Var(v) for each unknown's variance v. `noise`: as the fit used it,
/// that is scaled by the misfit's scale.
CalibrationResult uncertain(const Measurements& measurements, const Model& model, const Fit& fit,
                            const JointNoise& noise, const Misfit& misfit);

} // namespace naocal
