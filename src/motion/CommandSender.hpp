#pragma once

#include "framework/core/Module.hpp"
#include "framework/core/Parameter.hpp"
#include "motion/PosePlayer.hpp"
#include "motion/SensorProvider.hpp"

namespace naocal {

/// Answers every state of the robot with the desired pose, offsets added and within the limits, and with its lights.
/// Offsets that change do not make the robot jump: what is added follows them at a limited speed, and not before it
/// stands on both feet again.
class CommandSender final : public Module {
public:
  CommandSender(RobotInterface& robot, const Robot& drawing)
      : Module{"CommandSender"}, robot_{robot}, limits_{drawing} {}
  void cycle() override;

private:
  RobotInterface& robot_;
  JointLimits limits_;
  JointOffsets added_;
  bool isFirst_ = true;                                                     // offsets are added at once
  Parameter<double> offsetSpeed_{*this, "offsetSpeed", checkWithin<1, 90>}; // [deg/s]
  Dependency<SensorFrame> measured_{*this, "measured"};
  Dependency<JointOffsets> offsets_{*this, "JointCalibrationData"};
  Dependency<DesiredPose> desired_{*this, "desiredPose"};
  Dependency<PlayerState> player_{*this, "player"};
  Production<RawAngles> sent_{*this, "sentAngles"};
};

} // namespace naocal
