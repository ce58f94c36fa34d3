#pragma once

#include "diagnosis/Diagnosis.hpp"

#include <functional>
#include <limits>
#include <optional>

namespace naocal {

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
