#pragma once

#include "poses/PoseOrder.hpp"
#include "poses/RandomAttitude.hpp"

namespace naocal {

/// A safe way from one pose to another.
struct PoseWay {
  std::vector<Eigen::VectorXd> via; // angles to pass through on the way, none: straight on [rad]
  double seconds = 0;
};

/// Straight on where that is safe; else along the line between the poses' points in the ranges that they were drawn
/// from, which keeps the centre of mass over the foot. Absent: neither is safe.
std::optional<PoseWay> safeWay(const Robot& robot, const Scene& scene, const PoseOptions& options,
                               const SievedPose& from, const SievedPose& to);

} // namespace naocal
