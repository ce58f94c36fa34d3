#pragma once

#include "calibration/Calibration.hpp"

#include <string>
#include <vector>

namespace naocal {

/// Finds weak directions, predicts the error on the field and decides whether the result should be used; fills `weak`,
/// `floorErrorAt2m`, `warnings`, `verdict`, `usable`
/// and `sentence`.
void assess(const Measurements& measurements, const Model& model, CalibrationResult& result);

struct Accidents;

/// The verdict in words. `cause`: the likeliest cause, where one is missing. `firm`: the reason that forbids use
/// whatever the cause, if any.
std::string formatVerdict(const CalibrationResult& result, const Accidents& accidents, const std::string& cause,
                          const std::string& firm);

/// As files have it: "good", "cause-missing", "do-not-use".
std::string toString(ResultVerdict verdict);

/// Of all warnings.
std::vector<std::string> toSentences(const std::vector<Warning>& warnings);

} // namespace naocal
