#pragma once

#include "framework/core/Clock.hpp"
#include "hardware/messages/CompensatedAngles.hpp"

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace naocal {

/// A command of the brain to the pose player. A newer request replaces an older one; numbers increase.
struct PoseRequest {
  enum class Kind {
    go,   // through `points`, stay at the last one
    home, // back to the stand along the path it came
    wait, // stay; a chest button press is the operator's answer and does not send the robot home
    rest, // motors off
  };
  std::uint64_t number = 0;
  Kind kind = Kind::home;
  std::string name;                      // name of the pose, for display
  std::vector<CompensatedAngles> points; // waypoints [rad]; the caller guarantees balance along each segment
  bool held = false;                     // a person holds the robot until the next request other than `wait`
};

/// State of the pose player.
struct PlayerState {
  enum class Phase {
    off,     // motors off
    moving,  // to a request's last point, or home
    holding, // at rest, at a point or where it was stopped
    fallen,  // motors weak
  };
  Phase phase = Phase::off;
  std::uint64_t request = 0; // number of the last request handled
  bool held = false;         // a person holds the robot, or is asked to
  bool needsHands = false;   // held on its way out: on one foot, or on its way back
  bool done = false;         // the request is complete
  TimePoint doneAt;          // time of completion
  bool atHome = false;       // holding the stand
  CompensatedAngles home;    // the stand [rad]
  double progress = 0;       // 0..1 of the current motion
  double secondsLeft = 0;    // of the current motion [s]
  std::string reason;        // one sentence: reason of a refusal, stop or wait; empty otherwise
  std::uint64_t presses = 0; // chest button presses that did not send the robot home: it was there, waited for an
                             // answer, or motors were off
  std::uint64_t falls = 0;   // times that the torso was tilted so far that the motors were made weak
};
void to_json(nlohmann::json& out, const PlayerState& state);

} // namespace naocal
