#pragma once

#include "hardware/messages/CompensatedAngles.hpp"
#include "robot/Robot.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// What each encoder shows too much [rad]. Both hip yaw-pitches have the one motor's.
struct JointOffsets {
  PerJoint<double> values{};
};
void to_json(nlohmann::json& out, const JointOffsets& offsets);

/// angles = raw - offsets: where the joints are when their encoders show `raw`.
CompensatedAngles compensate(const RawAngles& raw, const JointOffsets& offsets);

/// The robot's joint limits in the order of `jointNames`.
class JointLimits {
public:
  explicit JointLimits(const Robot& robot);

  /// Each angle within its joint's limits, those included that depend on another joint's angle.
  template <class Angles> Angles clamp(const Angles& angles) const {
    Angles result = angles;
    clamp(result.values);
    return result;
  }

  /// How fast a joint may turn [rad/s]; 0 for hands.
  double maxSpeed(std::size_t joint) const;

private:
  void clamp(PerJoint<double>& values) const;

  const Robot& robot_;
  PerJoint<std::optional<std::size_t>> drawn_; // the joint's index in the drawing; absent: hands
};

/// raw = desired + offsets: what to send so that the joints come to `desired`. Both are kept within the limits: the
/// joint's own stop counts its angle, the motor's controller what the encoder shows. Both hip yaw-pitches get one
/// angle.
RawAngles toMotorAngles(const CompensatedAngles& desired, const JointOffsets& offsets, const JointLimits& limits);

} // namespace naocal
