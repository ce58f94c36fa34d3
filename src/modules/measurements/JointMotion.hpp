#pragma once

#include "measurements/Measurements.hpp"

#include <cstddef>
#include <vector>

namespace naocal {

/// How far apart the captures take a joint [rad, m]; 0 without captures.
double motionOf(std::size_t joint, const Measurements& measurements);

} // namespace naocal
