#pragma once

#include "robot/Kinematics.hpp"

#include <Eigen/Core>

namespace naocal {

/// What gravity does to a robot of which one link is held still, and how that changes with the angles.
struct GravityLoad {
  Eigen::VectorXd torque;        // as `gravityTorques`, per joint [Nm]
  Eigen::MatrixXd torqueByAngle; // d(torque of row)/d(angle of column), one column per joint [Nm/rad]
  Eigen::VectorXd torqueGrowth;  // d(torque)/d(angle of its own motor), per joint [Nm/rad]
  Eigen::MatrixXd growthByAngle; // d(torqueGrowth of row)/d(angle of column), where it is asked for [Nm/rad^2]
  Eigen::Vector3d com;           // the whole robot's centre of mass in the held link's frame [m]
  Eigen::Matrix3Xd comByAngle;   // one column per joint [m/rad]
};

/// With U = g up . sum(m p), up fixed in the held link: let joint J turn what lies beyond it (seen from the held link)
/// about a_J with the lever L_J = sum m (p - pivot). Then dU/dq_J = g up . (a_J x L_J), and where K lies beyond J
///
///   d2U/dq_J dq_K = g up . (a_J x (a_K x L_K)), else 0, and with I before J
///   d3U/dq_I dq_J dq_K = g up . (a_I x (a_J x (a_K x L_K))).
GravityLoad gravityLoad(const Robot& robot, const ModelState& belief, const LinkPoses& torsoFromLink,
                        std::size_t heldLink, const Eigen::Vector3d& upInTorso, bool withGrowthByAngle = false);

constexpr double gravity = 9.81; // [m/s^2]

/// The whole robot's mass [kg] and its centre of mass in the torso's frame [m]. Its drawing must have masses.
struct CentreOfMass {
  double mass = 0;
  Eigen::Vector3d inTorso = Eigen::Vector3d::Zero();
};
CentreOfMass centreOfMass(const Robot& robot, const LinkPoses& torsoFromLink);

/// tau_J = -dU/dq_J [Nm] per joint: gravity's generalised force with `heldLink` (a sole, or the torso) held still and
/// all other angles fixed; positive where gravity drives the angle positive. A motor that drives two joints feels both:
/// the sum stands at each of them. `upInTorso`: unit vector against gravity, in the torso's frame.
Eigen::VectorXd gravityTorques(const Robot& robot, const ModelState& belief, const LinkPoses& torsoFromLink,
                               std::size_t heldLink, const Eigen::Vector3d& upInTorso);

} // namespace naocal
