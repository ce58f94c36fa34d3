#pragma once

#include "framework/core/Module.hpp"
#include "framework/core/Parameter.hpp"
#include "hardware/messages/JointSample.hpp"
#include "motion/SensorProvider.hpp"

#include <optional>

namespace naocal {

/// Says how fast the encoders turn and since when the robot has been still, and keeps the last seconds for the brain.
///
/// A speed is the change over `window` seconds, divided by them: over one cycle an encoder's step alone would look like
/// 0.13 rad/s.
class JointHistory final : public Module {
public:
  JointHistory() : Module{"JointHistory"} {}
  void cycle() override;

private:
  bool isStill(const JointSample& moment) const;

  Parameter<double> window_{*this, "window", checkShare};                     // [s]
  Parameter<double> fastestJoint_{*this, "fastestJoint", checkWithin<0, 10>}; // that counts as still [rad/s]
  Parameter<double> fastestTurn_{*this, "fastestTurn",
                                 checkWithin<0, 10>}; // of the torso, that counts as still [rad/s]
  Dependency<SensorFrame> measured_{*this, "measured"};
  Dependency<CompensatedAngles> angles_{*this, "angles"};
  Dependency<RawAngles> sent_{*this, "sentAngles"};
  Production<JointSampleHistory> moments_{*this, "jointHistory"};
  Production<double> stillFor_{*this, "stillFor"}; // [s]
  std::optional<TimePoint> stillSince_;
};

} // namespace naocal
