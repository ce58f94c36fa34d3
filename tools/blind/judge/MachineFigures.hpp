#pragma once

#include "judge/Tally.hpp"

namespace blind {

/// All figures that the benchmark of robots with a URDF must reach, and whether each is met.
std::vector<Required> machineFigures(const Tally& tally);

} // namespace blind
