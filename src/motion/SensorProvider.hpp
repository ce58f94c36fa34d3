#pragma once

#include "framework/Module.hpp"
#include "framework/Production.hpp"
#include "motion/Measured.hpp"

namespace naocal {

/// Waits for the robot's next state: the motion thread's pace. Goes on without one after a tenth of a second, so that
/// the thread can end and say what is wrong.
class SensorProvider final : public Module {
public:
  explicit SensorProvider(RobotInterface& robot) : Module{"SensorProvider"}, robot_{robot} {}
  void cycle() override;

private:
  RobotInterface& robot_;
  Production<Measured> measured_{*this, "measured"};
  Production<RobotLink> link_{*this, "robotLink"};
  Production<Health> health_{*this, "health"};
};

} // namespace naocal
