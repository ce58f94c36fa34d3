#pragma once

#include "calibration/Calibration.hpp"

namespace naocal {

/// Finds weak directions, predicts the error on the field and decides whether the result should be used; fills `weak`,
/// `floorErrorAt2m`, `warnings`, `verdict`, `usable`
/// and `sentence`.
void assess(const Measurements& measurements, const Model& model, CalibrationResult& result);

/// As files have it: "good", "cause-missing", "do-not-use".
std::string toString(ResultVerdict verdict);

/// Of all warnings.
std::vector<std::string> toSentences(const std::vector<Warning>& warnings);

} // namespace naocal
