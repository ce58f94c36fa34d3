#pragma once

#include "world/Drawing.hpp"
#include "world/Flaws.hpp"

namespace blind {

inline constexpr double gravity = 9.81; // [m/s^2]

/// A rotation about the origin, then a translation.
struct Transform {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const { return turn * point + shift; }
  Transform operator*(const Transform& other) const { return {turn * other.turn, turn * other.shift + shift}; }
  Transform inverse() const { return {turn.transpose(), -(turn.transpose() * shift)}; }
};

Eigen::Matrix3d rotationAbout(const Eigen::Vector3d& axis, double angle); // Rodrigues' formula
Transform floorTransform(double x, double y, double yaw);                 // on the floor
Eigen::Matrix3d tiltRotation(double roll, double pitch);                  // Ry(pitch) * Rx(roll)

/// Link poses by a product of exponentials: a point at p in the torso's frame at zero angles moves to
/// exp(screw_1 q_1) ... exp(screw_n q_n) p (Brockett 1984).
class Skeleton {
public:
  Skeleton(const Drawing& drawing, const Flaws& flaws);

  using Posture = std::vector<Transform>; // by joint: motion of its link from its pose at zero angles
  Posture posture(const Eigen::VectorXd& angles) const;

  Transform torsoFromSole(const Posture& posture, int side) const;
  /// x forward along the optical axis; `mountTurn`: applied after the nominal mount; `shift`: in the head's frame.
  Transform torsoFromCamera(const Posture& posture, int camera, const Eigen::Matrix3d& mountTurn,
                            const Eigen::Vector3d& shift) const;
  Eigen::Vector3d centreOfMass(const Posture& posture) const; // in the torso's frame [m]
  /// Gravity torque on each joint with one sole fixed, `up` in the torso's frame [Nm]. Both hip yaw-pitch joints get
  /// the sum at their motor.
  Eigen::VectorXd torques(const Posture& posture, int side, const Eigen::Vector3d& up) const;
  double mass() const { return mass_; }

private:
  struct Screw {
    int parent;
    Eigen::Vector3d axis, point; // at zero angles in the torso's frame
  };
  struct Weight {
    int joint;
    double kilograms;
    Eigen::Vector3d point;
  };
  Eigen::Vector3d centre(const Posture& posture, const Weight& weight) const;

  const Drawing& drawing_;
  std::vector<Screw> screws_;
  std::vector<Weight> weights_;
  std::array<Eigen::Vector3d, 2> soles_;
  std::array<std::vector<bool>, 2> inLeg_; // between torso and that sole
  double mass_ = 0;
};

} // namespace blind
