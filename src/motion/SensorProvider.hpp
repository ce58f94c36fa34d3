#pragma once

#include "framework/core/Module.hpp"
#include "hardware/RobotInterface.hpp"

#include <algorithm>
#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// The last reported robot state; `isNew` in the cycle in which it arrived.
struct SensorFrame {
  bool isNew = false;
  RobotState state;
  double since = 0; // the previous state [s]; 0 for the first

  /// Time step for motions in this cycle [s], from 0 to 0.03 s: neither a gap in the states nor a clock that was set
  /// causes a jump.
  double step() const { return std::clamp(since, 0.0, 0.03); }
};
void to_json(nlohmann::json& out, const SensorFrame& measured);

/// Battery and temperature summary for display.
struct Health {
  double battery = 0; // 0 empty .. 1 full
  bool charging = false;
  std::string_view joint; // hottest joint
  double temperature = 0; // its temperature [degC]
};
Health summarizeHealth(const RobotState& state);
void to_json(nlohmann::json& out, const Health& health);
void to_json(nlohmann::json& out, const RobotStatus& link);

/// Waits for the robot's next state and thereby paces the motion thread. Continues without a state after 100 ms, so
/// that the thread can end and report problems.
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
