#pragma once

#include "python/SharedCaptures.hpp"

#include "calibration/Calibration.hpp"
#include "calibration/result/ResultFile.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// A calibration with what it was made from: Python's `Result`.
struct Solved {
  SharedCaptures captures;
  Model model;
  CalibrationResult fit;

  FittedModel fitted() const { return {captures->measurements, model, fit}; }
  /// RESULT.json.
  nlohmann::json json() const;
};

} // namespace naocal
