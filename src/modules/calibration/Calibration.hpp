#pragma once

#include "calibration/CalibrationResult.hpp"

namespace naocal {

/// Calibrates the robot: start, fit, noise levels, refit, missing effects, uncertainty, outliers, verdict. Throws
/// InputError if there is nothing to fit or no start keeps all observed corners in front of the camera.
CalibrationResult calibrate(const Measurements& measurements, const Model& model,
                            const CalibrationOptions& options = {});

} // namespace naocal
