#pragma once

#include "framework/Dependency.hpp"
#include "framework/Module.hpp"
#include "framework/Parameter.hpp"
#include "framework/Production.hpp"
#include "motion/JointOffsets.hpp"
#include "motion/Measured.hpp"

#include <array>

namespace naocal {

/// What the robot measured at one moment, for those who look at it later: pictures are exposed before they arrive.
struct JointMoment {
  RawAngles raw;
  CompensatedAngles angles;
  PerJoint<double> speeds{};       // of the encoders [rad/s]
  PerJoint<double> sent{};         // what the motors were sent last, raw [rad]
  PerJoint<double> temperatures{}; // [degC]
  PerJoint<double> currents{};     // [A]
  std::array<double, 2> tilt{};    // torso roll, pitch [rad]
  std::array<double, 3> turning{}; // gyroscope [rad/s]
  std::array<double, 8> forces{};  // soles [kg]
  double stillFor = 0;             // how long nothing has moved [s]; 0 while something does
};
/// Between two moments; the time of stillness is 0 unless both have it.
JointMoment interpolated(const JointMoment& from, const JointMoment& to, double fraction);
void to_json(nlohmann::json& out, const JointMoment& moment);

/// Three seconds at the V6's pace.
using JointMoments = History<JointMoment, 256>;

/// Says how fast the encoders turn and since when the robot has been still, and keeps the last seconds for the brain.
///
/// A speed is the change over `window` seconds, divided by them: over one cycle an encoder's step alone would look like
/// 0.13 rad/s.
class JointHistory final : public Module {
public:
  JointHistory() : Module{"JointHistory"} {}
  void cycle() override;

private:
  bool isStill(const JointMoment& moment) const;

  Parameter<double> window_{*this, "window"};             // [s]
  Parameter<double> fastestJoint_{*this, "fastestJoint"}; // that counts as still [rad/s]
  Parameter<double> fastestTurn_{*this, "fastestTurn"};   // of the torso, that counts as still [rad/s]
  Dependency<Measured> measured_{*this, "measured"};
  Dependency<CompensatedAngles> angles_{*this, "angles"};
  Dependency<RawAngles> sent_{*this, "sentAngles"};
  Production<JointMoments> moments_{*this, "jointHistory"};
  Production<double> stillFor_{*this, "stillFor"}; // [s]
  std::optional<TimePoint> stillSince_;
};

} // namespace naocal
