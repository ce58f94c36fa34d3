#pragma once

#include "framework/core/History.hpp"
#include "hardware/messages/CompensatedAngles.hpp"

#include <array>
#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// Readings of one instant, kept for images, which arrive after their exposure.
struct JointSample {
  RawAngles raw;
  CompensatedAngles angles;
  PerJoint<double> speeds{};       // encoder speeds [rad/s]
  RawAngles sent;                  // last command to the motors [rad]
  PerJoint<double> temperatures{}; // [degC]
  PerJoint<double> currents{};     // [A]
  std::array<double, 2> tilt{};    // torso roll, pitch [rad]
  std::array<double, 3> turning{}; // gyroscope [rad/s]
  std::array<double, 8> forces{};  // soles [kg]
  double stillFor = 0;             // time since the last motion [s]; 0 during motion
};
/// Linear interpolation; `sent` is the nearer one's; `stillFor` is 0 unless both have it.
JointSample interpolate(const JointSample& from, const JointSample& to, double fraction);
void to_json(nlohmann::json& out, const JointSample& moment);

/// Three seconds at the V6's rate (12 ms).
using JointSampleHistory = History<JointSample, 256>;

} // namespace naocal
