#pragma once

#include "calibration/result/CalibrationResult.hpp"

namespace naocal {

/// Calibrates the robot: first fit, noise levels, missing effects, displaced boards, uncertainty, outliers, verdict.
/// Throws InputError if there is nothing to fit or to estimate (`requireUnknowns`), or no start keeps all observed
/// corners in front of the camera.
CalibrationResult calibrate(const Measurements& measurements, const Model& model,
                            const CalibrationOptions& options = {});

/// Throws InputError if the model has no requested unknown beside placements: a calibration would learn nothing about
/// the robot.
void requireUnknowns(const Measurements& measurements, const Model& model);

} // namespace naocal
