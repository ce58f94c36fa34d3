#pragma once

#include "framework/core/Module.hpp"
#include "framework/core/Parameter.hpp"
#include "hardware/messages/JointSample.hpp"
#include "motion/SensorProvider.hpp"

#include <optional>

namespace naocal {

/// Computes joint speeds and the duration of stillness, and keeps the last seconds for the brain.
///
/// A speed is the change over `window` seconds divided by `window`; over a single cycle, one encoder step would look
/// like 0.13 rad/s.
class JointHistory final : public Module {
public:
  JointHistory() : Module{"JointHistory"} {}
  void cycle() override;

private:
  bool isStill(const JointSample& moment) const;

  Parameter<double> window_{*this, "window", checkShare};                     // [s]
  Parameter<double> fastestJoint_{*this, "fastestJoint", checkWithin<0, 10>}; // speed limit of stillness [rad/s]
  Parameter<double> fastestTurn_{*this, "fastestTurn",
                                 checkWithin<0, 10>}; // angular speed limit of stillness, torso [rad/s]
  Dependency<SensorFrame> measured_{*this, "measured"};
  Dependency<CompensatedAngles> angles_{*this, "angles"};
  Dependency<RawAngles> sent_{*this, "sentAngles"};
  Production<JointSampleHistory> moments_{*this, "jointHistory"};
  Production<double> stillFor_{*this, "stillFor"}; // [s]
  std::optional<TimePoint> stillSince_;
};

} // namespace naocal
