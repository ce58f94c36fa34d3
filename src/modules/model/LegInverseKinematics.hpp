#pragma once

#include "geometry/RigidTransform.hpp"
#include "model/Robot.hpp"

#include <Eigen/Core>
#include <optional>

namespace naocal {

/// Closed-form leg angles for a wanted torsoFromSole and a given hip yaw-pitch: hip roll, hip pitch, knee pitch, ankle
/// pitch, ankle roll [rad], written into `angles` at the leg's joints. Six numbers of pose, five free joints: the one
/// freedom that hip yaw-pitch takes is the sole's yaw, so without a given hip yaw-pitch it is solved too.
/// Absent where the leg cannot reach. Joint limits are not judged here.
struct LegSolution {
  double hipYawPitch = 0, hipRoll = 0, hipPitch = 0, kneePitch = 0, anklePitch = 0, ankleRoll = 0; // [rad]
};

/// All six angles for an exactly reached torsoFromSole. `side`: "left" or "right".
std::optional<LegSolution> legAngles(const Robot& robot, std::string_view side, const RigidTransform& torsoFromSole);

/// Five angles for a given hip yaw-pitch: the sole's position, and its z axis, are reached exactly; its yaw follows.
std::optional<LegSolution> legAngles(const Robot& robot, std::string_view side, const RigidTransform& torsoFromSole,
                                     double hipYawPitch);

} // namespace naocal
