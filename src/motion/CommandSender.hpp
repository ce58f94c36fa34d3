#pragma once

#include "framework/core/Module.hpp"
#include "framework/core/Parameter.hpp"
#include "motion/PosePlayer.hpp"
#include "motion/SensorProvider.hpp"

namespace naocal {

/// Answers every robot state with the desired pose and the LEDs; adds offsets and keeps angles within limits. Changes
/// of offsets are applied at a limited speed, and only while the robot stands on both feet, so that it does not jump.
class CommandSender final : public Module {
public:
  CommandSender(RobotInterface& robot, const Robot& drawing)
      : Module{"CommandSender"}, robot_{robot}, limits_{drawing} {}
  void cycle() override;

private:
  RobotInterface& robot_;
  JointLimits limits_;
  JointOffsets added_;
  bool isFirst_ = true;                                                     // first command: full offsets
  Parameter<double> offsetSpeed_{*this, "offsetSpeed", checkWithin<1, 90>}; // [deg/s]
  Dependency<SensorFrame> measured_{*this, "measured"};
  Dependency<JointOffsets> offsets_{*this, "JointCalibrationData"};
  Dependency<DesiredPose> desired_{*this, "desiredPose"};
  Dependency<PlayerState> player_{*this, "player"};
  Production<RawAngles> sent_{*this, "sentAngles"};
};

} // namespace naocal
