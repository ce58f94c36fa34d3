#pragma once

#include "simulation/SimulationPlan.hpp"

namespace naocal {

/// Poses for a plan's boards and cameras, for a robot that stands at the origin: on one foot the most informative
/// stable ones (poses/PoseGenerator.hpp), on both feet attitudes of the torso with both soles flat and the head turned
/// to a board. Throws InputError when not enough are found. The same seed gives the same poses.
std::vector<CommandedPose> planStandingPoses(const Robot& robot, const SimulationPlan& plan, SupportFoot supportFoot,
                                             std::size_t count, std::uint64_t seed);

} // namespace naocal
