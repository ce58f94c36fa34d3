#pragma once

#include "brain/CalibrationScript.hpp"
#include "calibration/EffectiveOffsets.hpp"
#include "calibration/ResultFile.hpp"
#include "data/Capture.hpp"

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

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
  bool isRunning() const { return phase != Phase::idle && phase != Phase::finished && phase != Phase::failed; }
};
void to_json(nlohmann::json& out, const CalibrationState& state);

/// The poses of the present round in which pictures are taken, before they are played.
struct PublishedPoses {
  int round = 0, step = 0; // the pose that comes next, or is being taken
  struct Pose {
    std::string name;
    CompensatedAngles angles; // [rad]
  };
  std::vector<Pose> poses;
};
void to_json(nlohmann::json& out, const PublishedPoses& poses);

/// Those of a round, the first at `step` or behind it next.
PublishedPoses listPoses(int round, const CalibrationRound& steps, std::size_t step);

/// A picture that was taken, and what was found in it.
struct PublishedCapture {
  int number = 0, round = 0;
  std::string pose, camera;
  std::optional<int> corners; // absent: not looked at yet
  std::vector<std::string> boards;
};
void to_json(nlohmann::json& out, const PublishedCapture& capture);

/// What the first round's captures said.
struct PublishedOutcome {
  struct Offset {
    std::string joint;
    double before = 0, after = 0, sigma = 0; // [deg]
    double learned = 0;                      // as in a result
  };
  std::vector<Offset> joints;
  std::vector<std::string> warnings; // sentences, with what to do
  std::string before;                // the keys of both mounts as they were set before, JSON; empty: nothing was tried
  std::string diagnosis;             // how well the model fits, in a sentence or two; empty until that is known
};
void to_json(nlohmann::json& out, const PublishedOutcome& outcome);

/// Those offsets that the captures tell.
std::vector<ShownOffset> learnedOffsets(std::vector<ShownOffset> offsets);

/// The offsets that were learned beside those before; of each that was not a warning, with the poses in which no board
/// was seen.
PublishedOutcome summarizeOutcome(const StoredResult& before, const std::vector<ShownOffset>& offsets,
                                  const std::vector<PublishedCapture>& captures);

} // namespace naocal
