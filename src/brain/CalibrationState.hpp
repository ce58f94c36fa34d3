#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace naocal {

/// How a calibration on the robot fares.
struct CalibrationState {
  enum class Phase { idle, preparing, goingHome, waiting, moving, collecting, solving, checking, finished, failed };
  Phase phase = Phase::idle;
  std::string kind;                              // what runs, or ran last
  std::string sentence;                          // what it does or waits for, or how it ended
  std::string question;                          // to the person; empty: none is open
  int questionNumber = 0;                        // that answers it
  int pose = 0, poses = 0;                       // taken, of the present round
  int captures = 0;                              // taken in both rounds
  std::optional<double> secondsLeft;             // of the present round
  std::optional<double> errorBefore, errorAfter; // of corners that were not used to calibrate [px]

  /// Neither idle nor at an end.
  bool runs() const { return phase != Phase::idle && phase != Phase::finished && phase != Phase::failed; }
};
void to_json(nlohmann::json& out, const CalibrationState& state);

} // namespace naocal
