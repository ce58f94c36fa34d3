#pragma once

#include "hardware/RobotCommand.hpp"
#include "hardware/RobotState.hpp"

#include <algorithm>
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

} // namespace naocal
