#pragma once

#include "hardware/Joints.hpp"

#include <array>

namespace naocal {

/// Brightness of one coloured light, each 0 .. 1.
struct Rgb {
  float red = 0, green = 0, blue = 0;
  bool operator==(const Rgb&) const = default;
};

/// Eyes of this colour ask the person beside the robot to hold it.
constexpr Rgb holdMe{1, 0.75f, 0};

/// The robot's lights, each list in the robot's own order.
struct Leds {
  Rgb chest, leftFoot, rightFoot;
  std::array<Rgb, 8> leftEye{};  // from 45 degrees on, counting down
  std::array<Rgb, 8> rightEye{}; // from 0 degrees on, counting up
  std::array<float, 10> leftEar{}, rightEar{};
  std::array<float, 12> skull{};
  bool operator==(const Leds&) const = default;
};

/// What the motors shall do until the next command.
struct RobotCommand {
  RawAngles angles;             // targets; the right hip yaw-pitch is ignored, one motor drives both
  PerJoint<double> stiffness{}; // 0 .. 1 of the motor's torque; 0 or less: the motor is off
  Leds leds;
};

} // namespace naocal
