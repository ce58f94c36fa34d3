#pragma once

#include "hardware/RobotCommand.hpp"
#include "hardware/RobotState.hpp"

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace naocal {

/// How the connection to the robot fares.
struct RobotLink {
  std::uint64_t states = 0;     // received
  std::uint64_t lostStates = 0; // that the robot measured but this program did not get, as far as the driver can tell
  std::uint64_t reconnects = 0; // since the first connection
  std::string problem;          // one sentence while there is no connection; empty while there is
};

/// Joints, sensors and lights of a robot: a real one, a replayed one or a simulated one.
///
/// Threads: made and destroyed by whoever starts the motion thread, while that does not run; all other calls come from
/// the motion thread alone. The motion loop is
///
///     while (running) {
///       if (const auto state = robot.waitForState(timeout)) { robot.send(modules(*state)); }
///     }
///
/// so the robot's pace is the loop's. Nothing here throws after construction: a lost connection is absence (no state)
/// and a sentence in `link()`, and it is mended by the next calls.
class RobotInterface {
public:
  virtual ~RobotInterface() = default;

  /// Who it is, for the configuration; absent when the robot has not told within `timeout`. Called
  /// before the first `waitForState`, if at all.
  virtual std::optional<RobotIdentity> waitForIdentity(std::chrono::milliseconds timeout) = 0;

  /// Blocks until the robot has measured anew; of several that wait the newest is given, the others are counted as
  /// lost. Absent after `timeout` without a state (wall time), or at the end of a replay.
  virtual std::optional<RobotState> waitForState(std::chrono::milliseconds timeout) = 0;

  /// Answers the state that was given last. Never blocks; without a connection nothing happens.
  virtual void send(const RobotCommand& command) = 0;

  /// Between two states: 12 ms (V6), 10 ms (V5).
  virtual std::chrono::nanoseconds period() const = 0;

  /// Nothing will come any more: a replay is over. False for everything that has no end.
  virtual bool ended() const { return false; }

  virtual RobotLink link() const = 0;
};

} // namespace naocal
