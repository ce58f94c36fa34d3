#pragma once

#include "diagnosis/Diagnosis.hpp"

#include <functional>
#include <limits>
#include <optional>

namespace naocal {

/// How far a fit is off.
struct GrossMisfit {
  double rmsPx = std::numeric_limits<double>::infinity();       // infinite where no fit was possible
  double farShare = 1;                                          // of the corners lies where no physics puts them
  bool absurd = true;                                           // offsets that no robot has
  double explainedPx = std::numeric_limits<double>::infinity(); // rms with the likeliest effect in the model

  static GrossMisfit assess(const CalibrationResult& fit, const Model& model);
};

/// Where the fit is grossly off: a joint whose angles have the wrong sign, cameras whose names are swapped, or a robot
/// or a board that was put elsewhere between two captures, tried by fitting the sets so corrected. Absent where the
/// misfit is small or no such correction mends it. `misfit`: of the sets as they are. `mayBeMirrored`: motors worth a
/// fit where the one as they are still tells.
std::optional<DataAnomaly> findSetupError(const Measurements& measurements, const GrossMisfit& misfit,
                                          const std::function<bool(std::size_t)>& mayBeMirrored);

} // namespace naocal
