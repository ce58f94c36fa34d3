#pragma once

#include "framework/core/Clock.hpp"
#include "hardware/messages/CompensatedAngles.hpp"

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace naocal {

/// What the brain asks the pose player to do. A newer request replaces an older one; each has a larger number.
struct PoseRequest {
  enum class Kind {
    go,   // through `points`, and stay at the last one
    home, // back to the stand the way it came
    wait, // stay for a person's answer: the chest button gives it, instead of sending the robot home
    rest, // motors off
  };
  std::uint64_t number = 0;
  Kind kind = Kind::home;
  std::string name;                      // of the pose, for people
  std::vector<CompensatedAngles> points; // checked by who asks: the robot stands all along the lines between them [rad]
  bool held = false;                     // a person was asked to hold the robot, until the next but a `wait`
};

/// How the pose player fares.
struct PlayerState {
  enum class Phase {
    off,     // motors off
    moving,  // towards a request's last point, or home
    holding, // still at a point or where it was stopped
    fallen,  // motors weak
  };
  Phase phase = Phase::off;
  std::uint64_t request = 0; // the last one that was looked at
  bool held = false;         // a person holds the robot, or is to take hold of it now
  bool needsHands = false;   // it was held on the way from its stand: it is on one foot, or on its way back
  bool done = false;         // that request came to its end
  TimePoint doneAt;          // when it did
  bool atHome = false;       // holding the stand
  CompensatedAngles home;    // that stand [rad]
  double progress = 0;       // 0..1 of the present motion
  double secondsLeft = 0;    // of it [s]
  std::string reason;        // one sentence: why it refused, stopped or waits; empty otherwise
  std::uint64_t presses =
      0; // of the chest button that did not send the robot home: it is there, waits for an answer, or motors are off
};
void to_json(nlohmann::json& out, const PlayerState& state);

} // namespace naocal
