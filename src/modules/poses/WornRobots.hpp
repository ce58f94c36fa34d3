#pragma once

#include "poses/RandomAttitude.hpp"

#include <vector>

namespace naocal {

/// Errors per joint of robots whose motors are off, uniform within Stability::jointError either way [rad]; each
/// `number` gives others.
std::vector<Eigen::VectorXd> wornRobots(const Robot& robot, const PoseOptions& options, std::size_t count,
                                        std::uint64_t number);

/// How a robot with errors stands when the poses are commanded.
std::vector<SievedPose> takenBy(const Eigen::VectorXd& errors, std::vector<SievedPose> poses);

} // namespace naocal
