#pragma once

#include "model/Kinematics.hpp"

#include <Eigen/Core>

namespace naocal {

constexpr double gravity = 9.81; // [m/s^2]

/// The whole robot's mass [kg] and its centre of mass in the torso's frame [m]. Its drawing must have masses.
struct CentreOfMass {
  double mass = 0;
  Eigen::Vector3d inTorso = Eigen::Vector3d::Zero();
};
CentreOfMass centreOfMass(const Robot& robot, const Posture& torsoFromLink);

/// tau_J = -dU/dq_J [Nm] per joint: gravity's generalised force with `heldLink` (a sole, or the torso) held still and
/// all other angles fixed; positive where gravity drives the angle positive. A motor that drives two joints feels both:
/// the sum stands at each of them. `upInTorso`: unit vector against gravity, in the torso's frame.
Eigen::VectorXd gravityTorques(const Robot& robot, const Belief& belief, const Posture& torsoFromLink,
                               std::size_t heldLink, const Eigen::Vector3d& upInTorso);

} // namespace naocal
