#pragma once

#include "calibration/Calibration.hpp"
#include "calibration/Fit.hpp"

#include <vector>

namespace naocal {

/// Perceived position error of a floor point 2 m ahead of the support foot [m] (1 sigma, both directions combined) due
/// to the physical unknowns, with the legs as captured and the head straight: median over captures. 0 without floor
/// boards. Scaled by the remaining misfit, as the covariance is.
double predictFloorErrorAt2m(const FittedModel& fitted);

/// Errors of a fit, the measurements that disagree with it, and its uncertainty: covariance = inverse Hessian of the
/// whitened problem, priors included, times the remaining misfit; standard errors averaged over the possible noise
/// levels; 95 % intervals from the Student's t distribution of that variance and kurtosis.
CalibrationResult estimateUncertainty(const Measurements& measurements, const Model& model, const Fit& fit,
                                      const NoiseLevels& levels);

/// Per unknown: ratio of the 95 % interval's half width to 1.96 standard errors at the most likely noise levels. Above
/// 1 where few poses leave the noise levels uncertain.
Eigen::VectorXd computeLevelWidening(const Residuals::Linear& linear, const Eigen::VectorXd& sigmas,
                                     const NoiseLevels& levels);

/// Minimum under another noise level, extrapolated from a linearisation nearby, and its covariance.
struct LinearMinimum {
  Eigen::VectorXd step; // from the unknowns of the linearisation
  Eigen::MatrixXd covariance;
};
LinearMinimum solveLinearized(const Residuals::Linear& linear, const Eigen::VectorXd& unknowns,
                              const Eigen::VectorXd& sigmas, const Noise& noise);

/// Directions in the space of the physical unknowns (each in units of its prior sigma) with a wide posterior.
std::vector<WeakDirection> findWeakDirections(const Model& model, const CalibrationResult& result);

} // namespace naocal
