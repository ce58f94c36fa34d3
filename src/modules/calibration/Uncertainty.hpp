#pragma once

#include "calibration/Calibration.hpp"
#include "calibration/Fit.hpp"

#include <vector>

namespace naocal {

/// How far off a floor point 2 m ahead of the support foot is perceived (1 sigma, both directions together) [m] because
/// of the physical unknowns, with the legs as in a capture and the head straight; the median over captures. 0 without
/// floor boards. Widened by the misfit that is left, as the covariance is.
double predictFloorErrorAt2m(const FittedModel& fitted);

/// A fit's numbers with what they are worth: covariance = inverse Hessian of the whitened problem, priors included,
/// times the misfit that is left; standard errors averaged over the levels of noise that are possible; 95 % intervals
/// of the Student's t with that variance and kurtosis.
CalibrationResult estimateUncertainty(const Measurements& measurements, const Model& model, const Fit& fit,
                                      const NoiseLevels& levels);

/// Per unknown, how much wider its 95 % interval is than 1.96 standard errors at the likeliest levels of noise, because
/// few poses leave them open.
Eigen::VectorXd computeLevelWidening(const Residuals::Linear& linear, const Eigen::VectorXd& sigmas,
                                     const NoiseLevels& levels);

/// The minimum under another noise level, from the linearisation at a near one: where it lies and its covariance.
struct LinearMinimum {
  Eigen::VectorXd step; // from the linearisation's unknowns
  Eigen::MatrixXd covariance;
};
LinearMinimum solveLinearized(const Residuals::Linear& linear, const Eigen::VectorXd& unknowns,
                              const Eigen::VectorXd& sigmas, const Noise& noise);

/// Directions in the space of the physical unknowns (each in units of its prior) whose posterior is still wide.
std::vector<WeakDirection> findWeakDirections(const Model& model, const CalibrationResult& result);

} // namespace naocal
