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

/// Whether a label names a wrong set-up that can be mended.
bool isSetUp(const std::string& label);

/// Takes the labels of wrong set-ups out of `with` and mends the sets accordingly: the angles of a reversed joint
/// change their sign; the zero of a joint whose count slipped is shifted by the whole motor turns (`slipSteps`) that a
/// first fit finds. Returns these labels. Throws InputError for a joint that the sets do not have.
std::vector<std::string> mendSetUps(std::vector<std::string>& with, const Robot& robot, std::vector<CaptureSet>& sets);

/// Joints whose fitted offset lies nearer to a whole number of motor turns, not zero, than to zero.
std::vector<DataAnomaly> findSlippedCounts(const FittedModel& fitted);

/// Size and character of a gross misfit.
struct GrossMisfit {
  double rmsPx = std::numeric_limits<double>::infinity(); // infinite if no fit was possible
  double farShare = 1;                                    // share of corners beyond `threshold::impossiblePx`
  std::string farJoint = {};                              // joint with the largest offset above 15 degrees; empty: none
  double farOffset = 0;                                   // its offset [rad]
  bool isLoose = false; // an estimated noise level of readings is that of no instrument, so that `rmsPx` hides misfit
  double explainedPx = std::numeric_limits<double>::infinity(); // rms with the likeliest effect in the model [px]
  std::vector<double> readings = {};                            // noise levels at which `rmsPx` counts readings

  static GrossMisfit assess(const Measurements& measurements, const CalibrationResult& fit, const Model& model);

  bool isGross() const;
  /// An offset or an rms error of no real robot.
  bool isAbsurd() const;
};

/// Explains a misfit by a set-up error: a joint with inverted sign, swapped camera names, or a robot or board moved far
/// between two captures. Tests each by fitting the corrected sets. Absent if the misfit is not gross or no correction
/// removes it. Without gross misfit but with a far offset, a joint with inverted sign that fits as well without such an
/// offset: the zero of the joint before it, half a turn off, can be the same. `misfit`: of the uncorrected sets.
/// `mayBeMirrored`: motors to test, unless `misfit` is absurd.
std::optional<DataAnomaly> findSetupError(const Measurements& measurements, const GrossMisfit& misfit,
                                          const std::function<bool(std::size_t)>& mayBeMirrored);

} // namespace naocal
