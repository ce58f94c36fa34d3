#pragma once

#include "math/RigidTransform.hpp"
#include "robot/Robot.hpp"

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string_view>

namespace naocal {

/// Hip yaw-pitch, hip roll, hip pitch, knee pitch, ankle pitch, ankle roll [rad].
using LegAngles = std::array<double, 6>;

/// Closed-form inverse kinematics of a leg (Kofinas, Orfanoudakis, Lagoudakis 2015: decoupled at the hip, where three
/// axes intersect). Selects the solution with the knee bent backwards (angle >= 0) and the ankle roll within 90
/// degrees. Does not check joint limits.
///
///   torsoFromSole = T(hip) R(axis, yawPitch) Rx(hipRoll) Ry(hipPitch) T(-thigh z) Ry(knee) T(-tibia z)
///                   Ry(anklePitch) Rx(ankleRoll) T(-footHeight z)
class LegKinematics {
public:
  /// The leg that ends in the sole named `side`. Throws InputError if the leg has a different structure.
  LegKinematics(const Robot& robot, std::string_view side);

  /// Joint indices in the order of `LegAngles`.
  const std::array<std::size_t, 6>& joints() const { return joints_; }

  /// All six angles for a sole pose; absent if out of reach.
  std::optional<LegAngles> solveAngles(const RigidTransform& torsoFromSole) const;

  /// Five angles for a given hip yaw-pitch (the motor may be determined by the other leg): reaches the sole's origin
  /// and z axis exactly, while its yaw follows from the hip yaw-pitch. Absent if out of reach.
  std::optional<LegAngles> solveAngles(const RigidTransform& torsoFromSole, double hipYawPitch) const;

private:
  /// Knee angle for a distance from hip to ankle [m]; absent if out of reach.
  std::optional<double> solveKnee(double distance) const;

  std::array<std::size_t, 6> joints_{};
  Eigen::Vector3d hip_ = Eigen::Vector3d::Zero(); // in the torso frame [m]
  Eigen::Vector3d yawPitchAxis_;                  // perpendicular to x
  double thigh_ = 0, tibia_ = 0, footHeight_ = 0; // [m]
};

/// Whether both legs of a robot have that structure, so that poses on its feet can be planned.
bool hasPlannableLegs(const Robot& robot);

} // namespace naocal
