#pragma once

#include "calibrate/Calibration.hpp"

namespace naocal {

/// Corners whose weight the loss took away, and sightings that lost most of their corners that way.
std::vector<Doubt> doubts(const Measurements& measurements, const CalibrationResult& result);

} // namespace naocal
