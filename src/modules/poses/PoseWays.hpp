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
                               const WayChecks& checks, const SievedPose& from, const SievedPose& to);

/// Poses in the quickest safe order, and the way to each from the one before it; absent: the first, or none is safe.
struct PosesInOrder {
  std::vector<SievedPose> poses;
  std::vector<std::optional<PoseWay>> ways;
};

/// Where there is no safe way through all of them the order is as given.
PosesInOrder inOrder(const Robot& robot, const Scene& scene, const PoseOptions& options, std::vector<SievedPose> poses);

} // namespace naocal
