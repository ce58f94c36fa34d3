#pragma once

#include "hardware/RobotInterface.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace naocal {

/// All are finite numbers, also in single precision, which robots speak.
inline bool isFinite(const PerJoint<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(float(value)); });
}
/// What moves the robot or tells that it falls: angles, tilt and turning.
inline bool isFinite(const RobotState& state) {
  return isFinite(state.angles.values) && state.torsoAngles.allFinite() && state.gyroscope.allFinite();
}
inline bool isFinite(const RobotCommand& command) {
  return isFinite(command.angles.values) && isFinite(command.stiffness);
}

/// Stiffness as robots want it: 0 .. 1, or -1, which switches a motor off.
inline float motorStiffness(double stiffness) {
  return stiffness > 0 ? float(std::min(stiffness, 1.0)) : -1.f;
}

/// LoLA's order of what can be touched, which the shared block of a V5 has too.
inline constexpr std::array<bool Touch::*, 14> touchOrder{
    &Touch::chestButton,    &Touch::headFront,     &Touch::headMiddle,    &Touch::headRear,      &Touch::leftFootLeft,
    &Touch::leftFootRight,  &Touch::leftHandBack,  &Touch::leftHandLeft,  &Touch::leftHandRight, &Touch::rightFootLeft,
    &Touch::rightFootRight, &Touch::rightHandBack, &Touch::rightHandLeft, &Touch::rightHandRight};

/// A joint's status as a whole number; -1 for what cannot be one.
constexpr int toStatusCode(double status) {
  return status >= 0 && status < 1e6 ? int(status) : -1;
}

} // namespace naocal
