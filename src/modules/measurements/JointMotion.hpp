#pragma once

#include "measurements/Measurements.hpp"

#include <cstddef>
#include <vector>

namespace naocal {

/// Motion of a joint over all captures below which it stood still: the play of gears and a few steps of encoders. Its
/// offset then changes no lever by a hundredth.
constexpr double stillRadians = 0.5 * 3.14159265358979323846 / 180; // [rad]
constexpr double stillMetres = 0.001;                               // [m], of slides

/// How far apart the captures take a joint [rad, m]; 0 without captures.
double motionOf(std::size_t joint, const Measurements& measurements);

/// Whether a joint keeps its angle in all captures.
bool isStill(std::size_t joint, const Measurements& measurements);

} // namespace naocal
