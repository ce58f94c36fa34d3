#pragma once

#include "hardware/RobotInterface.hpp"
#include "hardware/nao/LolaStream.hpp"

namespace naocal {

/// Driver of a NAO V6: its hardware service LoLA sends a state every 12 ms through a UNIX socket and expects a command
/// in reply. States are stamped on arrival. `waitForIdentity` consumes one state.
class LolaRobot : public RobotInterface {
public:
  explicit LolaRobot(std::filesystem::path socket = "/tmp/robocup");

  std::optional<RobotIdentity> waitForIdentity(std::chrono::milliseconds timeout) override;
  std::optional<RobotState> waitForState(std::chrono::milliseconds timeout) override;
  void send(const RobotCommand& command) override;
  std::chrono::nanoseconds period() const override { return std::chrono::milliseconds{12}; }
  RobotStatus status() const override;

private:
  std::optional<LolaState> waitForBoth(std::chrono::milliseconds timeout);

  LolaStream stream_;
  LolaCommandWriter writer_;
  RobotStatus link_;
};

} // namespace naocal
