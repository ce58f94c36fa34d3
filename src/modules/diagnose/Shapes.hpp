#pragma once

#include "diagnose/Diagnosis.hpp"

namespace naocal {

/// Adds to a finding the small expression that follows the misfit of its joint over its driver best: linear, square,
/// |x|, sign, root, sines and cosines of x to 8x, a step in time, the driver times the joint's torque.
void express(const Inquiry& inquiry, const Measurements& measurements, const DriverCell& cell, DriverFinding& finding);

} // namespace naocal
