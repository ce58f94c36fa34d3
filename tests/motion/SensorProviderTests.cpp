#include "motion/SensorProvider.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace naocal;

TEST_CASE("how a robot fares is told by its battery and its hottest joint") {
  // Proves the selected joint, and the criterion for charging.
  RobotState state;
  state.temperature.fill(30);
  state.temperature[*jointIndex("LKneePitch")] = 71;
  state.battery.charge = 0.4;
  state.battery.current = -1.2;
  const nlohmann::json told = summarizeHealth(state);
  CHECK(told["joint"] == "LKneePitch");
  CHECK(told["temperature"] == 71);
  CHECK(told["battery"] == 0.4);
  CHECK(told["charging"] == false);
  state.battery.current = 0.5;
  CHECK(summarizeHealth(state).charging);
}
