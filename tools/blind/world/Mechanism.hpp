#pragma once

#include "world/Session.hpp"
#include "world/Skeleton.hpp"

#include <algorithm>
#include <cmath>

namespace blind {

/// True link angle for an encoder reading `read`: the gear turns 1 + gain times as far, and the field of a magnet
/// (x, y) radii off its axis points to atan2(sin(angle) + y, cos(angle) + x).
double linkAngle(double read, const JointFlaws& flaws);

/// Play between motor and link: the link keeps its position until the end of the gap pushes it (Prandtl's stop).
class Play {
public:
  /// `friction` [Nm]: the link resists smaller loads within the gap.
  explicit Play(double gap, double friction = 0.03) : half_{gap / 2}, friction_{friction} {}
  void start(double motor) { link_ = motor; }
  /// Moves the motor.
  void pushTo(double motor) { link_ = std::min(std::max(link_, motor - half_), motor + half_); }
  /// A load above the friction drives the link to the end of the gap.
  void applyLoad(double motor, double torque) {
    if (std::abs(torque) > friction_) {
      link_ = motor + (torque > 0 ? half_ : -half_);
    }
  }
  double link() const { return link_; }

private:
  double half_, friction_, link_ = 0;
};

/// True angles at every reading: encoder errors, thermal drift, slip, play along the motion history, and springs in
/// equilibrium with gravity in the deflected posture.
std::vector<Eigen::VectorXd> trueAngles(const Robot& robot, const Session& session, const Skeleton& skeleton);

/// Rotation of the support sole on the floor: constant tilt plus elastic tilt under the centre of mass.
Eigen::Matrix3d soleTilt(const SoleFlaws& flaws, const Eigen::Vector3d& centreInSole);

} // namespace blind
