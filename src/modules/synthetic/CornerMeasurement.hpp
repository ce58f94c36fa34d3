#pragma once

#include "synthetic/SimulationPlan.hpp"
#include "synthetic/Walk.hpp"

namespace naocal {

/// The corners that the pictures of a walk show, without noise: one list of boards per capture.
std::vector<std::vector<BoardCorners>> cornersInView(const Walk& walk, const SimulationPlan& plan);

/// Moves one board, in the exposure of one picture that shows at least eight of its corners, by `distance` [m] in a
/// direction drawn at random. Absent when no picture shows as many.
std::optional<DisplacedBoard> displaceOneBoard(Walk& walk, const SimulationPlan& plan, double distance,
                                               Randomness& chance);

/// Adds a detector's noise, and gross errors, which are returned by name.
std::vector<GrossCorner> spoil(std::vector<Capture>& captures, const CornerNoise& noise, Randomness& chance);

} // namespace naocal
