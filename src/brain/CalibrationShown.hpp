#pragma once

#include "brain/CalibrationStep.hpp"
#include "calibration/EffectiveOffsets.hpp"
#include "calibration/ResultFile.hpp"
#include "data/Capture.hpp"

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

/// What a calibration lets people see while it runs and when it has ended.
namespace naocal {

/// The poses of the present round in which pictures are taken, before they are played.
struct ShownPoses {
  int round = 0, step = 0; // the pose that comes next, or is being taken
  struct Pose {
    std::string name;
    CompensatedAngles angles; // [rad]
  };
  std::vector<Pose> poses;
};
void to_json(nlohmann::json& out, const ShownPoses& poses);

/// Those of a round, the first at `step` or behind it next.
ShownPoses shownPoses(int round, const CalibrationRound& steps, std::size_t step);

/// A picture that was taken, and what was found in it.
struct ShownCapture {
  int number = 0, round = 0;
  std::string pose, camera;
  std::optional<int> corners; // absent: not looked at yet
  std::vector<std::string> boards;
};
void to_json(nlohmann::json& out, const ShownCapture& capture);

/// What the first round's captures said.
struct ShownOutcome {
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
void to_json(nlohmann::json& out, const ShownOutcome& outcome);

/// Those offsets that the captures tell.
std::vector<ShownOffset> learned(std::vector<ShownOffset> offsets);

/// The offsets that were learned beside those before; of each that was not a warning, with the poses in which no board
/// was seen.
ShownOutcome shownOutcome(const StoredResult& before, const std::vector<ShownOffset>& offsets,
                          const std::vector<ShownCapture>& captures);

} // namespace naocal
