#pragma once

#include "poses/CapturePlan.hpp"
#include "poses/PosePlan.hpp"

namespace naocal {

/// Prints candidate counts, standard errors of the offsets, board placements and transitions between poses.
void printPlan(const PosePlan& plan);

/// Prints candidate counts, standard errors of what the poses tell, and what they do not tell.
void printPlan(const CapturePlan& plan);

} // namespace naocal
