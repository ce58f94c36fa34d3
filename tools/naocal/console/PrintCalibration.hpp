#pragma once

#include "calibration/Calibration.hpp"

#include <vector>

namespace naocal {

/// Prints a calibration: fit, noise, estimates with error bars, weak directions, doubtful captures, verdict.
void printCalibration(const std::vector<CaptureSet>& sets, const Measurements& measurements, const Model& model,
                      const CalibrationResult& result);

} // namespace naocal
