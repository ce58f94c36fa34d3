#pragma once

#include "framework/core/Module.hpp"
#include "hardware/RobotInterface.hpp"

#include <algorithm>
#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// What the robot has reported last; `isNew` in the cycle in which it came.
struct SensorFrame {
  bool isNew = false;
  RobotState state;
  double since = 0; // the state before [s]; 0 of the first

  /// How far what moves may go on in this cycle [s]: silence is no reason to jump.
  double step() const { return std::min(since, 0.03); }
};
void to_json(nlohmann::json& out, const SensorFrame& measured);

/// How a robot fares, for people.
struct Health {
  double battery = 0; // 0 empty .. 1 full
  bool charging = false;
  std::string_view joint; // the hottest
  double temperature = 0; // its [degC]
};
Health summarizeHealth(const RobotState& state);
void to_json(nlohmann::json& out, const Health& health);
void to_json(nlohmann::json& out, const RobotStatus& link);

/// Waits for the robot's next state: the motion thread's pace. Goes on without one after a tenth of a second, so that
/// the thread can end and say what is wrong.
class SensorProvider final : public Module {
public:
  explicit SensorProvider(RobotInterface& robot) : Module{"SensorProvider"}, robot_{robot} {}
  void cycle() override;

private:
  RobotInterface& robot_;
  Production<SensorFrame> measured_{*this, "measured"};
  Production<RobotStatus> link_{*this, "robotLink"};
  Production<Health> health_{*this, "health"};
};

} // namespace naocal
