#pragma once

#include "robot/Robot.hpp"

#include <Eigen/Geometry>
#include <vector>

namespace naocal {

/// Mechanics of the synthetic robot: an independent implementation that shares only the drawing's numbers with robot/.
///
/// Product of exponentials (Brockett 1984): at zero angles all frames are parallel, joint i is a screw with the axis
/// a_i through the point p_i of the torso's frame, and
///   torsoFromLink = prod_i exp(screw_i q_i) * T(p_link),   exp(screw q) = [R(a, q), (1 - R(a, q)) p].
class SyntheticBody {
public:
  explicit SyntheticBody(const Robot& drawing);

  /// torsoFromLink of every link, for one angle per joint of the drawing [rad].
  std::vector<Eigen::Isometry3d> forwardKinematics(const Eigen::VectorXd& angles) const;

  double mass() const; // [kg]
  /// In the torso's frame [m].
  Eigen::Vector3d centreOfMass(const std::vector<Eigen::Isometry3d>& torsoFromLink) const;

  /// tau_J = -(U(q_J + h) - U(q_J - h)) / 2h [Nm] per joint: decrease of the potential energy U as a motor turns, with
  /// `heldLink` fixed and its z axis vertical. Both joints of one motor have the motor's value.
  Eigen::VectorXd gravityTorques(const Eigen::VectorXd& angles, std::size_t heldLink) const;

private:
  struct Part {
    std::optional<std::size_t> parent, joint;
    Eigen::Vector3d point, axis; // of the screw, torso frame at zero angles [m]
    double mass;                 // [kg]
    Eigen::Vector3d centreOfMass;
  };
  double potentialEnergy(const Eigen::VectorXd& angles, std::size_t heldLink) const; // [J]

  std::vector<Part> parts_;
  std::vector<std::size_t> motors_; // per joint: the joint whose motor drives it
};

} // namespace naocal
