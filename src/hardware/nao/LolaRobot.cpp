#include "hardware/nao/LolaRobot.hpp"

#include "hardware/nao/DeviceConventions.hpp"

namespace naocal {

LolaRobot::LolaRobot(std::filesystem::path socket) : stream_{std::move(socket)} {}

std::optional<LolaState> LolaRobot::waitForBoth(std::chrono::milliseconds timeout) {
  const TimePoint deadline = std::chrono::steady_clock::now() + timeout;
  while (const LolaStream::Received* received = stream_.receive(deadline)) {
    link_.lostStates += received->overtaken;
    std::variant<LolaState, std::string> read = parseLolaState(received->message);
    if (auto* state = std::get_if<LolaState>(&read)) {
      if (!isFinite(state->state)) { // the stream itself is in step
        ++link_.lostStates;
        link_.problem = "the robot reports an angle, a tilt or a turning that is not a finite number";
        continue;
      }
      ++link_.states;
      link_.problem.clear();
      state->state.time = received->arrived;
      return *state;
    }
    ++link_.lostStates;
    link_.problem = std::get<std::string>(read);
    stream_.reconnect(link_.problem);
  }
  return std::nullopt;
}

std::optional<RobotIdentity> LolaRobot::waitForIdentity(std::chrono::milliseconds timeout) {
  const auto both = waitForBoth(timeout);
  return both ? std::optional{both->identity} : std::nullopt;
}

std::optional<RobotState> LolaRobot::waitForState(std::chrono::milliseconds timeout) {
  const auto both = waitForBoth(timeout);
  return both ? std::optional{both->state} : std::nullopt;
}

void LolaRobot::send(const RobotCommand& command) {
  const std::span<const std::uint8_t> message = writer_.encode(command);
  if (message.empty()) {
    link_.problem = "a command was not sent because it asks for an angle or stiffness that is not a finite number";
    return;
  }
  stream_.send(message);
}

RobotStatus LolaRobot::status() const {
  RobotStatus link = link_;
  link.reconnects = stream_.connections() > 0 ? stream_.connections() - 1 : 0;
  if (!stream_.isConnected()) {
    link.problem = stream_.problem();
  }
  return link;
}

} // namespace naocal
