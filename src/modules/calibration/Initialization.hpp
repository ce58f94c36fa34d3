#pragma once

#include "estimation/Model.hpp"
#include "measurements/Measurements.hpp"

#include <Eigen/Core>

namespace naocal {

/// Where the search starts: the given unknowns, with the unknown floor placements of boards and stances found from the
/// pictures. A board's pose in the camera comes from its corners alone (homography); the joints only say where that
/// camera stands, so even joints that are off by many degrees put the board within decimetres. Placements are then
/// carried from what is known from stance to board to stance.
Eigen::VectorXd initializePlacements(const Measurements& measurements, const Model& model,
                                     const Eigen::VectorXd& unknowns);

/// From there on all unknowns together, until boards' poses as seen and as the chain puts them agree (BoardAlignment):
/// near enough for the corners' problem to have one minimum.
Eigen::VectorXd alignBoards(const Measurements& measurements, const Model& model, const Eigen::VectorXd& unknowns);

} // namespace naocal
