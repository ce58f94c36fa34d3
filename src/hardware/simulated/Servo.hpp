#pragma once

#include "data/Capture.hpp"
#include "math/Angles.hpp"
#include "math/Sampling.hpp"
#include "robot/Robot.hpp"

namespace naocal {

/// Parameters common to all servos.
struct ServoMechanics {
  Seconds lag{0.03};                // motor time constant
  double maxAcceleration = 200;     // [rad/s^2]
  double droop = 1e-3;              // compliance of the motor at full stiffness [rad/Nm]
  double stopBand = radians(0.05);  // distance to the target where friction stops the motor, 1 sigma [rad]
  double startBand = radians(0.15); // distance from the target beyond which the motor starts again [rad]
  double gearFriction = 0.1;        // torque above which the joint moves through the gear's play [Nm]
  Seconds throughPlay{0.05};        // time it takes to move through the play
};

/// A motor with its gear. The joint's angle is the motor's plus the position within the gear's play: joint = motor +
/// gap, |gap| <= play / 2. A torque pushes the gap to its side; without torque the joint trails behind the motor until
/// the play is used up.
class Servo {
public:
  /// `joint`: limits and maximum speed. `play`: full width [rad].
  Servo(const Joint& joint, double play, const ServoMechanics& mechanics, double motorAngle);

  /// Sets the motor's target. Stiffness 0 or less: the motor keeps its position, held by the gear.
  void command(double motorTarget, double stiffness);

  /// `torque`: load on the joint [Nm].
  void advance(Seconds step, double torque, RandomStream& chance);

  double motor() const { return motor_; } // encoder angle without offset [rad]
  double gap() const { return gap_; }     // [rad]
  double speed() const { return speed_; } // of the motor [rad/s]

private:
  void movePlay(Seconds step, double torque, double turned);

  AngleRange limits_;
  double maxSpeed_, play_;
  ServoMechanics mechanics_;
  double motor_, target_, stiffness_ = 0, speed_ = 0, gap_ = 0;
  double stopWithin_ = 0; // stop distance of the current motion [rad]
  bool moving_ = false;
};

} // namespace naocal
