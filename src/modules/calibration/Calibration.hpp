#pragma once

#include "calibration/CalibrationResult.hpp"

namespace naocal {

/// The straight line from captures to trustworthy numbers: start, fit, noise levels, fit, what may be missing,
/// uncertainty, doubts, verdict. Throws InputError when there is nothing to fit.
CalibrationResult calibrate(const Measurements& measurements, const Model& model,
                            const CalibrationOptions& options = {});

} // namespace naocal
