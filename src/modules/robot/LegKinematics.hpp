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

/// Which angles put a foot where it is wanted, in closed form (Kofinas, Orfanoudakis, Lagoudakis 2015: decoupled at the
/// hip, where three axes meet). Of its several solutions the one of a leg is taken: knee bent backwards (angle >= 0),
/// rolls of the ankle within 90 degrees. Joint limits are not judged here.
///
///   torsoFromSole = T(hip) R(axis, yawPitch) Rx(hipRoll) Ry(hipPitch) T(-thigh z) Ry(knee) T(-tibia z)
///                   Ry(anklePitch) Rx(ankleRoll) T(-footHeight z)
class LegKinematics {
public:
  /// The leg that ends in the sole named `side`. Throws InputError when the robot's leg is not built as above.
  LegKinematics(const Robot& robot, std::string_view side);

  /// The robot's joints in the order of `LegAngles`.
  const std::array<std::size_t, 6>& joints() const { return joints_; }

  /// All six angles for a wanted pose of the sole; absent where the leg does not reach.
  std::optional<LegAngles> solveAngles(const RigidTransform& torsoFromSole) const;

  /// Five angles for a given hip yaw-pitch (the motor may be bound by the other leg): the sole's origin and its z axis
  /// are reached exactly, its yaw is what the hip yaw-pitch leaves. Absent where the leg does not reach.
  std::optional<LegAngles> solveAngles(const RigidTransform& torsoFromSole, double hipYawPitch) const;

private:
  /// The knee's angle for a distance from hip to ankle [m].
  std::optional<double> solveKnee(double distance) const;

  std::array<std::size_t, 6> joints_{};
  Eigen::Vector3d hip_ = Eigen::Vector3d::Zero(); // in the torso's frame [m]
  Eigen::Vector3d yawPitchAxis_;                  // at a right angle to x
  double thigh_ = 0, tibia_ = 0, footHeight_ = 0; // [m]
};

} // namespace naocal
