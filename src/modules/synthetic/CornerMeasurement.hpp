#pragma once

#include "synthetic/SimulationPlan.hpp"
#include "synthetic/Walk.hpp"

namespace naocal {

/// The corners that the pictures of a walk show, without noise: one list of boards per capture.
std::vector<std::vector<BoardCorners>> cornersInView(const Walk& walk, const SimulationPlan& plan);

/// Moves one board, in the exposure of one picture, by `distance` [m] in a direction drawn at random. Before and after,
/// the picture shows at least eight of its corners, and at least two other pictures do: else nothing could tell that
/// the board is not where it always was. Absent when there is no such picture.
std::optional<DisplacedBoard> displaceOneBoard(Walk& walk, const SimulationPlan& plan, double distance,
                                               Randomness& chance);

/// Adds a detector's noise, and gross errors, which are returned by name.
std::vector<GrossCorner> spoil(std::vector<Capture>& captures, const CornerNoise& noise, Randomness& chance);

} // namespace naocal
