#pragma once

#include "calibrate/Calibration.hpp"

namespace naocal {

/// How far off a floor point 2 m ahead of the support foot is perceived (1 sigma, both directions together) [m] because
/// of the physical unknowns, with the legs as in a capture and the head straight; the median over captures. 0 without
/// floor boards. Widened by the misfit that is left, as the covariance is.
double floorErrorAt2m(const Measurements& measurements, const Model& model, const CalibrationResult& result);

} // namespace naocal
