#pragma once

#include "poses/PosePlan.hpp"

namespace naocal {

/// Prints candidate counts, standard errors of the offsets, board placements and transitions between poses.
void printPlan(const PosePlan& plan);

} // namespace naocal
