#pragma once

#include "robot/Kinematics.hpp"

#include <Eigen/Core>

namespace naocal {

/// Gravity's effect on a robot with one link held still, and its derivatives with respect to the joint angles.
struct GravityLoad {
  Eigen::VectorXd torque;        // as `gravityTorques`, per joint [Nm]
  Eigen::MatrixXd torqueByAngle; // d(torque of row)/d(angle of column), one column per joint [Nm/rad]
  Eigen::VectorXd torqueGrowth;  // d(torque)/d(angle of its own motor), per joint [Nm/rad]
  Eigen::MatrixXd growthByAngle; // d(torqueGrowth of row)/d(angle of column), only if requested [Nm/rad^2]
  Eigen::Vector3d com;           // centre of mass of the whole robot in the held link's frame [m]
  Eigen::Matrix3Xd comByAngle;   // one column per joint [m/rad]
};

/// With U = g up . sum(m p), up fixed in the held link: joint J rotates the links beyond it (seen from the held link)
/// about a_J with the lever L_J = sum m (p - pivot). Then dU/dq_J = g up . (a_J x L_J), and where K lies beyond J
///
///   d2U/dq_J dq_K = g up . (a_J x (a_K x L_K)), else 0, and with I before J
///   d3U/dq_I dq_J dq_K = g up . (a_I x (a_J x (a_K x L_K))).
///
/// A prismatic joint K has a_K sum m in place of a_K x L_K; as J or I it has no second derivative.
GravityLoad gravityLoad(const Robot& robot, const ModelState& modelState, const LinkPoses& torsoFromLink,
                        std::size_t heldLink, const Eigen::Vector3d& upInTorso, bool withGrowthByAngle = false);

constexpr double gravity = 9.81; // [m/s^2]

/// Mass of the whole robot [kg] and its centre of mass in the torso frame [m]. Requires a description with masses.
struct CentreOfMass {
  double mass = 0;
  Eigen::Vector3d inTorso = Eigen::Vector3d::Zero();
};
CentreOfMass centreOfMass(const Robot& robot, const LinkPoses& torsoFromLink);

/// tau_J = -dU/dq_J [Nm] per joint: generalised force of gravity with `heldLink` (a sole, or the torso) held still and
/// all other angles fixed; positive where gravity drives the angle positive. If a motor drives several joints, all
/// their entries hold the sum of their torques times their ratios. `upInTorso`: unit vector against gravity, in the
/// torso frame.
Eigen::VectorXd gravityTorques(const Robot& robot, const ModelState& modelState, const LinkPoses& torsoFromLink,
                               std::size_t heldLink, const Eigen::Vector3d& upInTorso);

/// Gravity's torques about the normals n1, n2 of each joint's axis (`bearingNormals`, in the frame before the joint's
/// own turn) through the joint's origin [Nm], one column per joint: the bearing bears them. Sign and held link as in
/// `gravityTorques`.
Eigen::Matrix2Xd lateralTorques(const Robot& robot, const ModelState& modelState, const LinkPoses& torsoFromLink,
                                std::size_t heldLink, const Eigen::Vector3d& upInTorso);

} // namespace naocal
