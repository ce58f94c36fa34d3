#pragma once

#include "calibration/Calibration.hpp"

#include <string>
#include <vector>

namespace naocal {

/// Finds weak directions and judges the result. Fills `weak`, `verdict`, `usable`, `findings` and `sentence`.
void judgeResult(const Measurements& measurements, const Model& model, CalibrationResult& result);

/// The verdict as a sentence. `cause`: the likeliest missing effect, if any. `firm`: a reason that forbids use
/// regardless of the cause, if any.
std::string formatVerdict(const CalibrationResult& result, const std::string& cause, const std::string& firm);

/// As in files: "good", "cause-missing", "do-not-use".
std::string toString(ResultVerdict verdict);

} // namespace naocal
