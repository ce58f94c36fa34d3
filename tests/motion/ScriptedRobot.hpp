#pragma once

#include "hardware/RobotInterface.hpp"

#include <vector>

namespace naocal {

/// A robot whose joints reach their commands within one cycle while their motors are on. The test sets all other sensor
/// values.
class ScriptedRobot final : public RobotInterface {
public:
  ScriptedRobot() { state.accelerometer.z() = 9.81; }
  std::optional<RobotIdentity> waitForIdentity(std::chrono::milliseconds) override { return RobotIdentity{}; }
  std::optional<RobotState> waitForState(std::chrono::milliseconds) override {
    if (silent) {
      return std::nullopt;
    }
    state.time += period();
    return state;
  }
  void send(const RobotCommand& command) override {
    sent.push_back(command);
    for (std::size_t joint = 0; joint < jointCount; ++joint) {
      if (command.stiffness[joint] > 0 && !stuck[joint]) {
        state.angles[joint] = command.angles[joint];
      }
    }
  }
  std::chrono::nanoseconds period() const override { return std::chrono::milliseconds{12}; }
  RobotStatus status() const override { return {}; }

  RobotState state;
  std::vector<RobotCommand> sent;
  PerJoint<bool> stuck{}; // joints that do not move
  bool silent = false;
};

} // namespace naocal
