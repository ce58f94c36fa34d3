#pragma once

#include "hardware/messages/CompensatedAngles.hpp"
#include "robot/Robot.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// Encoder offsets [rad]: raw = angle + offset. Both hip yaw-pitches have the same value (one motor).
struct JointOffsets {
  PerJoint<double> values{};
};
void to_json(nlohmann::json& out, const JointOffsets& offsets);

/// angles = raw - offsets: true joint angles from encoder readings.
CompensatedAngles compensate(const RawAngles& raw, const JointOffsets& offsets);

/// The robot's joint limits, indexed like `jointNames`.
class JointLimits {
public:
  explicit JointLimits(const Robot& robot);

  /// Clamps each angle to its joint's limits, including limits that depend on another joint's angle.
  template <class Angles> Angles clamp(const Angles& angles) const {
    Angles result = angles;
    clamp(result.values);
    return result;
  }

  /// Maximum speed of a joint [rad/s]; 0 for hands.
  double maxSpeed(std::size_t joint) const;

private:
  void clamp(PerJoint<double>& values) const;

  const Robot& robot_;
  PerJoint<std::optional<std::size_t>> drawn_; // index in the drawing; absent: hands
};

/// raw = desired + offsets: motor command for `desired`. Clamps both: the mechanical stop limits the true angle, the
/// motor controller the encoder reading. Both hip yaw-pitches get the same angle.
RawAngles toMotorAngles(const CompensatedAngles& desired, const JointOffsets& offsets, const JointLimits& limits);

} // namespace naocal
