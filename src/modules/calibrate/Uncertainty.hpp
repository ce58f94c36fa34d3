#pragma once

#include "calibrate/Fit.hpp"

namespace naocal {

/// A fit's numbers with what they are worth: covariance = inverse Hessian of the whitened problem, priors included;
/// 95 % intervals with Student's t, whose degrees of freedom follow from how sure the noise levels are (Satterthwaite,
/// Biometrics Bulletin 2 (1946) 110): nu = 2 v^2 / Var(v) for each unknown's variance v.
CalibrationResult uncertain(const Measurements& measurements, const Model& model, const Fit& fit,
                            const JointNoise& noise);

} // namespace naocal
