#pragma once

#include "diagnosis/Diagnosis.hpp"

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Labels of wrong set-ups that can be mended, up to the joint's name.
inline constexpr char reversedJoint[] = "reversedJoint@", countSlip[] = "countSlip@";

/// Takes the labels of wrong set-ups out of `with` and mends the sets accordingly: the angles of a reversed joint
/// change their sign; the zero of a joint whose count slipped is shifted by the whole motor turns (`slipSteps`) that a
/// first fit finds. Returns these labels. Throws InputError for a joint that the sets do not have.
std::vector<std::string> mendSetUps(std::vector<std::string>& with, const Robot& robot, std::vector<CaptureSet>& sets);

/// Joints whose fitted offset lies nearer to a whole number of motor turns, not zero, than to zero.
std::vector<DataAnomaly> findSlippedCounts(const FittedModel& fitted);

/// Size and character of a gross misfit.
struct GrossMisfit {
  double rmsPx = std::numeric_limits<double>::infinity();       // infinite if no fit was possible
  double farShare = 1;                                          // share of corners beyond `threshold::impossiblePx`
  bool absurd = true;                                           // offset above 15 degrees, or rms of no real robot
  double explainedPx = std::numeric_limits<double>::infinity(); // rms with the likeliest effect in the model [px]

  static GrossMisfit assess(const CalibrationResult& fit, const Model& model);
};

/// Explains a gross misfit by a set-up error: a joint with inverted sign, swapped camera names, or a robot or board
/// moved far between two captures. Tests each by fitting the corrected sets. Absent if the misfit is small or no
/// correction removes it. `misfit`: of the uncorrected sets. `mayBeMirrored`: motors to test, unless `misfit` is
/// absurd.
std::optional<DataAnomaly> findSetupError(const Measurements& measurements, const GrossMisfit& misfit,
                                          const std::function<bool(std::size_t)>& mayBeMirrored);

} // namespace naocal
