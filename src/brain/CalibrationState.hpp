#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace naocal {

/// How a calibration on the robot fares.
struct CalibrationState {
  enum class Phase { idle, goingHome, moving, collecting, solving, checking, finished, failed };
  Phase phase = Phase::idle;
  std::string sentence;                          // what it does or waits for, or how it ended
  int pose = 0, poses = 0;                       // taken, of the present round
  int captures = 0;                              // taken in both rounds
  std::optional<double> secondsLeft;             // of the present round
  std::optional<double> errorBefore, errorAfter; // of corners that were not used to calibrate [px]
};
void to_json(nlohmann::json& out, const CalibrationState& state);

} // namespace naocal
