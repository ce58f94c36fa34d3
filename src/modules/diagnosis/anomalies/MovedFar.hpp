#pragma once

#include "diagnosis/DiagnosisResult.hpp"

#include <limits>
#include <optional>
#include <vector>

namespace naocal {

/// Size and character of a gross misfit.
struct GrossMisfit {
  double rmsPx = std::numeric_limits<double>::infinity();       // infinite if no fit was possible
  double farShare = 1;                                          // share of corners beyond `threshold::impossiblePx`
  double explainedPx = std::numeric_limits<double>::infinity(); // rms with the likeliest effect in the model [px]
  std::vector<double> readings = {};                            // noise levels at which `rmsPx` counts readings

  static GrossMisfit assess(const CalibrationResult& fit);
};

/// Explains corners that lie further off than any physics takes them by a robot or a board that was moved far between
/// two captures, too far for the linearised events: fits the captures with every such move. Absent if the misfit is not
/// so large. As a last resort, where nothing fits at all, other boards or another robot.
std::optional<DataAnomaly> findMovedFar(const Measurements& measurements, const GrossMisfit& misfit);

} // namespace naocal
