#pragma once

#include "calibration/Calibration.hpp"

#include <vector>

namespace naocal {

/// Prints a calibration: fit, noise, estimates with error bars, weak directions, doubtful captures, verdict.
void printCalibration(const FittedModel& fitted);

} // namespace naocal
