#pragma once

#include "estimation/Model.hpp"

#include <cstddef>
#include <vector>

namespace naocal {

/// Adds unknown placements that the measurements depend on. Boards and soles on the floor: x, y, yaw; elsewhere: all
/// six, or three for a single mark. Prior sigma: the set's own, else practically unconstrained.
void addPlacementTerms(const Measurements& measurements, Model& model);

/// Replaces the sigmas [m] or [rad] of these numbers of a placement (x, y, z, roll, pitch, yaw) that a set gives;
/// 0 there: not given. `sigmas`: one per number.
void setGivenSigmas(const Placement& given, const std::vector<std::size_t>& numbers, std::vector<double>& sigmas);

} // namespace naocal
