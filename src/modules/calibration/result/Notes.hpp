#pragma once

#include "calibration/result/CalibrationResult.hpp"
#include "calibration/result/Determination.hpp"

#include <vector>

namespace naocal {

/// What is good to know of a result, whatever its verdict: offsets that other terms imitate, doubtful measurements and
/// what they share, displaced boards, assumptions, what the captures hardly tell and might not show.
std::vector<Finding> listNotes(const FittedModel& fitted, const HeldOffsets& held);

} // namespace naocal
