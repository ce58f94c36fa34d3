#pragma once

#include "poses/PosePlan.hpp"

namespace naocal {

/// Adds the mirror image of every pose, taken on the other foot among the same boards, which lie symmetrically
/// (PlanOptions::mirrored): the feet side by side when the support changes. Sigmas are those of each foot's poses by
/// themselves, the better one for the head. Throws InputError where a mirror image is no valid pose.
void addMirrored(PosePlan& plan, const Robot& robot, const std::map<std::string, CameraIntrinsics>& cameras);

} // namespace naocal
