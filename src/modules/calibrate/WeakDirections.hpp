#pragma once

#include "calibrate/Calibration.hpp"

#include <string>
#include <vector>

namespace naocal {

/// Directions in the space of the physical unknowns (each in units of its prior) whose posterior is still wide.
std::vector<WeakDirection> weakDirections(const Model& model, const CalibrationResult& result);

/// "the left hip pitch" for jointOffset@LHipPitch.o, "the top camera's cameraRotation (ry)" for cameraRotation@top.ry.
std::string inWords(const std::string& unknownName);

} // namespace naocal
