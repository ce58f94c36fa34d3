#pragma once

#include "robot/Kinematics.hpp"

#include <Eigen/Core>
#include <utility>
#include <vector>

namespace naocal {

/// The distance between the segments p..q and r..s; either may be a point. Ericson: Real-time collision detection
/// (2005), 5.1.9.
double segmentDistance(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r,
                       const Eigen::Vector3d& s);

/// Whether a robot touches itself, by the capsules of its drawing. Two kinds of pairs say nothing and are left out:
/// links that one or two joints connect, whose limits see to it, and those within a centimetre of each other with all
/// joints at rest, such as a hanging hand and its own hip.
class SelfCollision {
public:
  /// `clearance`: what is nearer than that touches [m].
  explicit SelfCollision(const Robot& robot, double clearance = 0.005);

  bool collides(const LinkPoses& torsoFromLink) const;

private:
  bool areNear(std::size_t one, std::size_t other, const LinkPoses& torsoFromLink, double gap) const;

  const Robot& robot_;
  double clearance_;
  std::vector<std::pair<std::size_t, std::size_t>> pairs_; // of capsules
};

} // namespace naocal
