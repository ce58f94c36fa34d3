#pragma once

#include "calibration/Calibration.hpp"

#include <vector>

namespace naocal {

/// Tells a calibration to a person: fit, noise, estimates with error bars, what is weak or doubtful, whether to use it.
void printCalibration(const FittedModel& fitted);

} // namespace naocal
