#pragma once

#include "residuals/Measurements.hpp"

#include <vector>

namespace naocal {

/// Sorts the pictures into an order of their own, joins those of one reading, and readings of one pose; fills `poses`,
/// `joints` and `repeats`.
void groupReadings(const std::vector<CaptureSet>& sets, Measurements& measurements);

} // namespace naocal
