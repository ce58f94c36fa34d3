#pragma once

#include "brain/CalibrationScript.hpp"
#include "calibration/EffectiveOffsets.hpp"
#include "calibration/result/ResultFile.hpp"
#include "data/Capture.hpp"

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Progress and outcome of a calibration on the robot.
struct CalibrationState {
  enum class Phase { idle, preparing, goingHome, waiting, moving, collecting, solving, checking, finished, failed };
  Phase phase = Phase::idle;
  std::string kind;                              // running or last kind
  std::string sentence;                          // current action, reason to wait, or outcome
  std::string question;                          // open question to the operator; empty: none
  int questionNumber = 0;                        // value of `confirmed` that answers it
  int pose = 0, poses = 0;                       // finished and total, in the current round
  int captures = 0;                              // total of both rounds
  std::optional<double> secondsLeft;             // until the end of both rounds
  std::optional<double> errorBefore, errorAfter; // on corners not used for the calibration [px]

  /// Neither idle nor finished nor failed.
  bool isRunning() const { return phase != Phase::idle && phase != Phase::finished && phase != Phase::failed; }
};
void to_json(nlohmann::json& out, const CalibrationState& state);

/// The current round's poses with captures, published before they are played.
struct PublishedPoses {
  int round = 0, step = 0; // step: index of the current or next pose
  struct Pose {
    std::string name;
    CompensatedAngles angles; // [rad]
  };
  std::vector<Pose> poses;
};
void to_json(nlohmann::json& out, const PublishedPoses& poses);

/// Poses with captures of a round; `step` is the index of the current step in `steps`.
PublishedPoses listPoses(int round, const CalibrationRound& steps, std::size_t step);

/// A capture and its detections.
struct PublishedCapture {
  int number = 0, round = 0;
  std::string pose, camera;
  std::optional<int> corners; // absent: not processed yet
  std::vector<std::string> boards;
};
void to_json(nlohmann::json& out, const PublishedCapture& capture);

/// Result of the first round.
struct PublishedOutcome {
  struct Offset {
    std::string joint;
    double before = 0, after = 0, sigma = 0; // [deg]
    double learned = 0;                      // as in a result file
  };
  std::vector<Offset> joints;
  std::vector<std::string> warnings; // sentences that say what to do
  std::string before;                // keys of both mounts before the calibration, as JSON; empty: nothing was applied
  std::string diagnosis;             // model fit, one or two sentences; empty until known
};
void to_json(nlohmann::json& out, const PublishedOutcome& outcome);

/// The offsets that the captures determine (`isLearned`).
std::vector<EffectiveOffset> learnedOffsets(std::vector<EffectiveOffset> offsets);

/// Lists learned offsets beside the previous ones [deg]; adds a warning for each other offset, naming the poses in
/// which no board was detected.
PublishedOutcome summarizeOutcome(const StoredResult& before, const std::vector<EffectiveOffset>& offsets,
                                  const std::vector<PublishedCapture>& captures);

} // namespace naocal
