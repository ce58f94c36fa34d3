#pragma once

#include "brain/CalibrationRecorder.hpp"
#include "framework/configuration/Configuration.hpp"
#include "framework/core/Latest.hpp"
#include "runs/Run.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// Where a robot's runs are recorded.
struct RunRecording {
  std::filesystem::path folder; // empty: nowhere
  RunRobot robot;
  std::function<void(std::string_view sentence)> log = [](std::string_view) {}; // for runs that cannot be recorded
};

/// The newest runs of this robot, for clients that keep a copy.
struct PublishedRuns {
  std::vector<Run> runs; // by time
};
/// [{"id": .., "run": RUN.json}]
void to_json(nlohmann::json& out, const PublishedRuns& published);

/// Records this robot's calibrations, undos, falls and offsets that clients have saved, and publishes the newest. A run
/// that cannot be recorded gives a sentence in the log and changes nothing else. Used on one thread, except `take`.
class CalibrationRuns {
public:
  static constexpr std::size_t mostPublished = 10;
  static constexpr std::size_t mostSearched = 100; // for the run that an undo takes back: usually the newest

  /// The configuration must outlive it.
  CalibrationRuns(RunRecording recording, const Configuration& configuration)
      : recording_{std::move(recording)}, configuration_{configuration} {}

  /// A calibration that was checked; `folder`: its recording.
  struct Calibration {
    std::string kind;
    std::filesystem::path folder;
    CalibrationRecorder::ErrorComparison error;
    RunOutcome outcome;
  };
  void recordCalibration(const Calibration& calibration);
  /// An undo; `before`: the configured offsets that it took back [rad].
  void recordUndo(const std::map<std::string, double>& before);
  void recordFall();
  /// Notes the configured offsets, for `recordSaved`.
  void noteConfigured();
  /// Records the configured offsets, which a client has saved, unless the last run has set the same.
  void recordSaved();
  void publishNewest();

  /// The newest runs, unless already taken. On one other thread.
  const PublishedRuns* take() { return published_.take(); }

private:
  void record(const std::function<Run()>& make);
  /// This robot's newest runs by time.
  std::vector<Run> readNewest(std::size_t most) const;
  Run begin(std::string kind) const;

  RunRecording recording_;
  const Configuration& configuration_;
  std::map<std::string, double> noted_; // configured offsets after the last run, by joint [rad]
  Latest<PublishedRuns> published_;
};

} // namespace naocal
