#pragma once

#include "simulation/SimulationPlan.hpp"

namespace naocal {

/// Poses for a plan's boards and cameras, for a robot at the origin: on one foot the most informative stable ones
/// (poses/candidates/PoseSampler.hpp), on both feet random torso poses with both soles flat and the head turned to a
/// board. Throws InputError if not enough are found. Reproducible by seed.
std::vector<CommandedPose> planStandingPoses(const Robot& robot, const SimulationPlan& plan, SupportFoot supportFoot,
                                             std::size_t count, std::uint64_t seed);

} // namespace naocal
