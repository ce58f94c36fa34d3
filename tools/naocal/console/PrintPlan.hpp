#pragma once

#include "poses/PosePlan.hpp"

namespace naocal {

/// Prints how many candidates there were, how well the poses tell the offsets, where the boards go and the way from
/// pose to pose.
void printPlan(const PosePlan& plan);

} // namespace naocal
