#pragma once

#include "writer/ProjectedProduct.hpp"
#include "writer/machines/WorkcellPlanner.hpp"

namespace blind {

/// All measurements of a session in one vector; then the distances between places.
Eigen::VectorXd stackMeasurements(const Workcell& cell, const WorkcellSession& session);

/// Visibility of a change of the measurements to an observer who knows the noise but not the machine. Unknown are joint
/// offsets, the camera's mount, and the placements of boards, cameras beside the machine, trackers, markers and places;
/// derivatives are central differences. Random are the measurements, and the joints per approach and per pose.
ProjectedProduct workcellVisibility(const Workcell& cell, const WorkcellSession& session, const WorkcellPlan& plan);

} // namespace blind
