#pragma once

#include "diagnose/Diagnosis.hpp"

namespace naocal {

/// A cell of the map as a finding: its curve, and the small expression that follows the misfit best (linear, square,
/// |x|, sign, root, sines and cosines of x, 2x, 3x and 6x, a step in time, the driver times the joint's torque).
DriverFinding driverFinding(const Inquiry& inquiry, const Measurements& measurements, std::size_t cell);

} // namespace naocal
