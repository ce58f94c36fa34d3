#pragma once

#include <Eigen/Core>

namespace naocal {

/// The distance between the segments p..q and r..s; either may be a point. Ericson: Real-time collision detection
/// (2005), 5.1.9.
double segmentDistance(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r,
                       const Eigen::Vector3d& s);

} // namespace naocal
