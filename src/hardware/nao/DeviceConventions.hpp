#pragma once

#include "hardware/RobotInterface.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace naocal {

/// Whether all values are finite in single precision, which robots use.
inline bool isFinite(const PerJoint<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(float(value)); });
}
/// Whether angles, torso tilt and angular velocity are finite: the values that move the robot or detect a fall.
inline bool isFinite(const RobotState& state) {
  return isFinite(state.angles.values) && state.torsoAngles.allFinite() && state.gyroscope.allFinite();
}
inline bool isFinite(const RobotCommand& command) {
  return isFinite(command.angles.values) && isFinite(command.stiffness);
}

/// Stiffness as the robot expects it: 0 .. 1, or -1, which switches the motor off.
inline float motorStiffness(double stiffness) {
  return stiffness > 0 ? float(std::min(stiffness, 1.0)) : -1.f;
}

/// LoLA's order of touch sensors, also used in the shared block of a V5.
inline constexpr std::array<bool Touch::*, 14> touchOrder{
    &Touch::chestButton,    &Touch::headFront,     &Touch::headMiddle,    &Touch::headRear,      &Touch::leftFootLeft,
    &Touch::leftFootRight,  &Touch::leftHandBack,  &Touch::leftHandLeft,  &Touch::leftHandRight, &Touch::rightFootLeft,
    &Touch::rightFootRight, &Touch::rightHandBack, &Touch::rightHandLeft, &Touch::rightHandRight};

/// A joint's status as an integer; -1 if out of range.
constexpr int toStatusCode(double status) {
  return status >= 0 && status < 1e6 ? int(status) : -1;
}

} // namespace naocal
