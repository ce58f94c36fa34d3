#pragma once

#include "calibration/CandidateTests.hpp"

#include <memory>
#include <optional>

namespace naocal {

/// Calibrates the robot: first fit, noise levels, missing effects, displaced boards, uncertainty, outliers, verdict.
/// Throws InputError if there is nothing to fit or to estimate (`requireUnknowns`), or no start keeps all observed
/// corners in front of the camera.
CalibrationResult calibrate(const Measurements& measurements, const Model& model,
                            const CalibrationOptions& options = {});

/// A calibration, and the measurements as it weighs them.
struct WeighedCalibration {
  CalibrationResult result;
  std::optional<Measurements> weighed;         // absent: all at full weight
  std::shared_ptr<const CandidateTests> tests; // of the result's fit; absent if missing effects were not tested
};
/// The same, for further fits of other models to the same measurements at the same weights.
WeighedCalibration calibrateWeighing(const Measurements& measurements, const Model& model,
                                     const CalibrationOptions& options = {});

/// Throws InputError if the model has no requested unknown beside placements: a calibration would learn nothing about
/// the robot.
void requireUnknowns(const Measurements& measurements, const Model& model);

} // namespace naocal
