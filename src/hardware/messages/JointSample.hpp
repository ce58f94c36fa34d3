#pragma once

#include "framework/core/History.hpp"
#include "hardware/messages/CompensatedAngles.hpp"

#include <array>
#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// What the robot measured at one moment, for those who look at it later: pictures are exposed before they arrive.
struct JointSample {
  RawAngles raw;
  CompensatedAngles angles;
  PerJoint<double> speeds{};       // of the encoders [rad/s]
  RawAngles sent;                  // what the motors were sent last [rad]
  PerJoint<double> temperatures{}; // [degC]
  PerJoint<double> currents{};     // [A]
  std::array<double, 2> tilt{};    // torso roll, pitch [rad]
  std::array<double, 3> turning{}; // gyroscope [rad/s]
  std::array<double, 8> forces{};  // soles [kg]
  double stillFor = 0;             // how long nothing has moved [s]; 0 while something does
};
/// Between two moments; the time of stillness is 0 unless both have it.
JointSample interpolate(const JointSample& from, const JointSample& to, double fraction);
void to_json(nlohmann::json& out, const JointSample& moment);

/// Three seconds at the V6's pace.
using JointSampleHistory = History<JointSample, 256>;

} // namespace naocal
