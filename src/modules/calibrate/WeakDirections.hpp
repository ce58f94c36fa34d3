#pragma once

#include "calibrate/Calibration.hpp"

#include <vector>

namespace naocal {

/// Directions in the space of the physical unknowns (each in units of its prior) whose posterior is still wide.
std::vector<WeakDirection> weakDirections(const Model& model, const CalibrationResult& result);

} // namespace naocal
