#pragma once

#include "estimation/Model.hpp"
#include "measurements/Measurements.hpp"

#include <Eigen/Core>

namespace naocal {

/// Start of the search: the given unknowns, with unknown floor placements of boards and stances initialised from the
/// pictures. A board's pose in the camera comes from its corners alone (homography), and the camera's pose from the
/// joints; even joint errors of many degrees misplace a board by only a few decimetres. Known placements then propagate
/// between stances and boards.
Eigen::VectorXd initializePlacements(const Measurements& measurements, const Model& model,
                                     const Eigen::VectorXd& unknowns);

/// Refines all unknowns from there until board poses in the camera agree with the kinematic chain (BoardAlignment);
/// close enough for the corner problem to have a single minimum.
Eigen::VectorXd alignBoards(const Measurements& measurements, const Model& model, const Eigen::VectorXd& unknowns);

} // namespace naocal
