#pragma once

#include "robot/Kinematics.hpp"

#include <Eigen/Core>
#include <utility>
#include <vector>

namespace naocal {

/// Distance between the segments p..q and r..s; either may be a point. Ericson: Real-time collision detection (2005),
/// 5.1.9.
double segmentDistance(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r,
                       const Eigen::Vector3d& s);

/// Self-collision test with the capsules of the robot description. Ignores two kinds of pairs: links connected by at
/// most two joints, whose limits prevent contact, and capsules within 1 cm of each other with all joints at rest, such
/// as a hanging hand and the hip.
class SelfCollision {
public:
  /// `clearance`: capsules closer than this collide [m]. Keeps a reference to `robot`.
  explicit SelfCollision(const Robot& robot, double clearance = 0.005);

  bool collides(const LinkPoses& torsoFromLink) const;

private:
  bool areNear(std::size_t one, std::size_t other, const LinkPoses& torsoFromLink, double gap) const;

  const Robot& robot_;
  double clearance_;
  std::vector<std::pair<std::size_t, std::size_t>> pairs_; // pairs of capsules
};

} // namespace naocal
