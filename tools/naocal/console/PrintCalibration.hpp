#pragma once

#include "calibration/Calibration.hpp"

#include <vector>

namespace naocal {

/// Tells a calibration to a person: fit, noise, estimates with error bars, what is weak or doubtful, whether to use it.
void printCalibration(const std::vector<CaptureSet>& sets, const Measurements& measurements, const Model& model,
                      const CalibrationResult& result);

} // namespace naocal
