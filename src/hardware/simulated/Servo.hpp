#pragma once

#include "data/Capture.hpp"
#include "math/Angles.hpp"
#include "math/Sampling.hpp"
#include "robot/Robot.hpp"

namespace naocal {

/// How all servos of the make behave.
struct ServoMechanics {
  Seconds lag{0.03};                // the motor's time constant
  double maxAcceleration = 200;     // [rad/s^2]
  double droop = 1e-3;              // how far the motor yields to a torque at full stiffness [rad/Nm]
  double stopBand = radians(0.05);  // sigma of how near to its target friction stops the motor [rad]
  double startBand = radians(0.15); // how far off it must be to start again [rad]
  double gearFriction = 0.1;        // a lesser torque does not push the joint through its gear's play [Nm]
  Seconds throughPlay{0.05};        // which takes a greater one so long
};

/// One motor with its gear. The joint's angle is the motor's plus where it stands within the gear's play:
/// joint = motor + gap, |gap| <= play / 2. A torque pushes the gap to its own side; without one the joint trails behind
/// the motor until the play is used up.
class Servo {
public:
  /// `joint`: limits and greatest speed. `play`: the whole width [rad].
  Servo(const Joint& joint, double play, const ServoMechanics& mechanics, double motorAngle);

  /// The motor's target from now on. Stiffness 0 or less: it stays where it is, its gear holds it.
  void command(double motorTarget, double stiffness);

  /// `torque`: what pushes the joint [Nm].
  void advance(Seconds step, double torque, Randomness& chance);

  double motor() const { return motor_; } // what the encoder sees but for its offset [rad]
  double gap() const { return gap_; }     // [rad]
  double speed() const { return speed_; } // of the motor [rad/s]

private:
  void movePlay(Seconds step, double torque, double turned);

  AngleRange limits_;
  double maxSpeed_, play_;
  ServoMechanics mechanics_;
  double motor_, target_, stiffness_ = 0, speed_ = 0, gap_ = 0;
  double stopWithin_ = 0; // of this motion [rad]
  bool moving_ = false;
};

} // namespace naocal
