#include "motion/SensorProvider.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

nlohmann::json listOf(const Eigen::Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

} // namespace

void SensorProvider::cycle() {
  SensorFrame& measured = measured_.edit();
  auto state = robot_.waitForState(std::chrono::milliseconds{100});
  measured.isNew = state.has_value();
  if (state) {
    measured.since = measured.state.time == TimePoint{} ? 0 : toSeconds(state->time - measured.state.time);
    measured.state = *std::move(state);
    setCycleTime(measured.state.time);
    health_ = summarizeHealth(measured.state);
  }
  link_ = robot_.status();
}

void to_json(nlohmann::json& out, const SensorFrame& measured) {
  const RobotState& state = measured.state;
  const Touch& touch = state.touch;
  out = {{"isNew", measured.isNew},
         {"rawAngles", state.angles.values},
         {"stiffness", state.stiffness},
         {"currents", state.current},
         {"temperatures", state.temperature},
         {"status", state.status},
         {"accelerometer", listOf(state.accelerometer)},
         {"gyroscope", listOf(state.gyroscope)},
         {"torsoAngles", {state.torsoAngles.x(), state.torsoAngles.y()}},
         {"forces", state.forces},
         {"sonar", state.sonar},
         {"battery", {{"charge", state.battery.charge}, {"current", state.battery.current}}},
         {"touch",
          {{"chestButton", touch.chestButton},
           {"head", touch.headFront || touch.headMiddle || touch.headRear},
           {"leftFoot", touch.leftFootLeft || touch.leftFootRight},
           {"rightFoot", touch.rightFootLeft || touch.rightFootRight},
           {"leftHand", touch.leftHandBack || touch.leftHandLeft || touch.leftHandRight},
           {"rightHand", touch.rightHandBack || touch.rightHandLeft || touch.rightHandRight}}}};
}

Health summarizeHealth(const RobotState& state) {
  const auto hottest = std::max_element(state.temperature.begin(), state.temperature.end());
  return {state.battery.charge, state.battery.current > 0,
          jointNames[static_cast<std::size_t>(hottest - state.temperature.begin())], *hottest};
}

void to_json(nlohmann::json& out, const Health& health) {
  out = {{"battery", health.battery},
         {"charging", health.charging},
         {"joint", health.joint},
         {"temperature", health.temperature}};
}

void to_json(nlohmann::json& out, const RobotStatus& link) {
  out = {{"states", link.states},
         {"lostStates", link.lostStates},
         {"reconnects", link.reconnects},
         {"problem", link.problem}};
}

} // namespace naocal
