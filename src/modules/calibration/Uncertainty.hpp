#pragma once

#include "calibration/Calibration.hpp"
#include "calibration/Fit.hpp"

#include <vector>

namespace naocal {

/// Errors of a fit, the measurements that disagree with it, and its uncertainty: covariance = inverse Hessian of the
/// whitened problem at the remaining misfit (`temperPrecision`); standard errors averaged over the possible noise
/// levels; 95 % intervals from the Student's t distribution of that variance and kurtosis.
CalibrationResult estimateUncertainty(const Measurements& measurements, const Model& model, const Fit& fit,
                                      const NoiseLevels& levels);

/// Directions in the space of the physical unknowns (each in units of its prior sigma) with a wide posterior.
std::vector<WeakDirection> findWeakDirections(const Model& model, const CalibrationResult& result);

/// Wald statistic of a term's unknowns against zero: chi2 with one degree of freedom per unknown. With the estimates
/// and sigmas as reported, and the correlations of the fit.
double computeWald(const CalibrationResult& fit, const Term& term);

} // namespace naocal
