#pragma once

#include "writer/Session.hpp"
#include "writer/Skeleton.hpp"

#include <algorithm>
#include <cmath>

namespace blind {

/// The angle of a link whose encoder shows `read`: the gear turns 1 + gain times as far, and the field of a magnet
/// that sits (x, y) radii off its axis points to atan2(sin(angle) + y, cos(angle) + x).
double linkAngle(double read, const JointFlaws& flaws);

/// Play between motor and link: the link keeps its place until the motor's end of the gap pushes it (Prandtl's stop).
class Play {
public:
  /// `friction` [Nm] holds the link within the gap against weaker loads.
  explicit Play(double gap, double friction = 0.03) : half_{gap / 2}, friction_{friction} {}
  void start(double motor) { link_ = motor; }
  /// The motor goes to `motor`.
  void pushTo(double motor) { link_ = std::min(std::max(link_, motor - half_), motor + half_); }
  /// A load stronger than the gap's friction drives the link to the gap's end.
  void applyLoad(double motor, double torque) {
    if (std::abs(torque) > friction_) {
      link_ = motor + (torque > 0 ? half_ : -half_);
    }
  }
  double link() const { return link_; }

private:
  double half_, friction_, link_ = 0;
};

/// The true angles at every reading's time, by the mechanism: encoder, warmth, slip, play along the way that the joint
/// came, springs in balance with the weight they carry at the sagged posture.
std::vector<Eigen::VectorXd> trueAngles(const Robot& robot, const Session& session, const Skeleton& skeleton);

/// How the standing sole lies on the floor: shimmed, and tipped until its elasticity carries the centre of mass.
Eigen::Matrix3d soleTilt(const SoleFlaws& flaws, const Eigen::Vector3d& centreInSole);

} // namespace blind
