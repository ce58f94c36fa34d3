#pragma once

#include "brain/CalibrationRecorder.hpp"
#include "brain/CalibrationScript.hpp"
#include "brain/CalibrationStatus.hpp"
#include "framework/configuration/Configuration.hpp"
#include "framework/core/Latest.hpp"
#include "hardware/RobotInterface.hpp"
#include "math/Worker.hpp"
#include "robot/Robot.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace naocal {

/// What a calibration needs beside its parameters.
struct CalibrationContext {
  const Robot& drawing;
  RobotIdentity identity;
  Configuration& configuration;     // where results are applied and saved
  std::filesystem::path files;      // the configuration's folder, copied into recordings; poses/V6.json, models/V6.json
  std::filesystem::path recordings; // folder that gets one folder per calibration
};

/// What a calibration leaves to a thread of its own, so that no cycle waits for it: the ways between poses, finding
/// boards and writing captures, solving, applying, comparing. Each call returns at once, and is done in the order of
/// calls; what is found is taken later, and lost once another calibration has begun.
class CalibrationJobs {
public:
  using Rounds = std::array<CalibrationRound, 2>; // to calibrate, to check

  explicit CalibrationJobs(CalibrationContext context);
  ~CalibrationJobs() { finish(); }
  const CalibrationContext& context() const { return context_; }

  /// A calibration whose files go into `folder`, the configuration first: what is in effect now is what was before.
  void begin(std::filesystem::path folder);
  const std::filesystem::path& folder() const { return folder_; }

  /// Poses on feet: of a pose file's content, or of the configuration's file where that is empty; `checkPoses` of them
  /// on each foot to check.
  struct LegRounds {
    std::vector<SupportFoot> feet;
    RoundOptions options;
    int checkPoses;
    CompensatedAngles home;
    std::string asked;
  };
  void planLegs(LegRounds legs);

  /// A round's captures come from now on; each is looked at.
  void openRound(std::size_t round, CaptureSet header);
  void processCapture(std::size_t round, Capture capture, PublishedCapture shown, CameraFrame frame);

  /// Solves the first round's captures and puts into effect what they say, of offsets only the neck's if so wished.
  void solve(bool onlyHead);
  /// Compares it and what was before with the second round's captures; saves what helps, puts back what does not. Then
  /// asks of the first round's captures how well the model fits them.
  void check();
  /// Ends the calibration: nothing more is found but what was saved already, and what was put into effect and not saved
  /// is put back.
  void abandon();
  /// Takes back what the last calibration saved.
  void undo();
  /// Waits until nothing is done any more; what was put into effect and not saved stays so.
  void finish();

  /// What came of a job.
  struct PlannedRounds {
    Rounds rounds;
  };
  struct AppliedCalibration { // in effect, not saved
    PublishedOutcome outcome;
  };
  struct CheckedCalibration {
    CalibrationRecorder::ErrorComparison error;
    bool isKept; // what was applied is saved; else what was before is back
  };
  struct ModelDiagnosis {
    std::string sentence; // or two: how well the model fits
  };
  struct CalibrationUndone {}; // what was saved before is taken back
  struct JobFailure {
    std::string reason; // the middle of a sentence
  };
  using JobResult = std::variant<PlannedRounds, AppliedCalibration, CheckedCalibration, ModelDiagnosis,
                                 CalibrationUndone, JobFailure>;
  /// The next of them, in the order of jobs.
  std::optional<JobResult> takeResult();
  /// All captures that were looked at so far, in their order; nullptr: none since the last call.
  const std::vector<PublishedCapture>* takeProcessed();

private:
  /// A round's session, made and used by the worker alone.
  struct Round {
    std::optional<CalibrationRecorder> session;
  };
  struct ProcessedCaptures {
    std::filesystem::path folder;
    std::vector<PublishedCapture> captures;
  };
  struct QueuedResult {
    std::filesystem::path folder; // of the calibration that it is about
    JobResult result;
  };
  /// A job's result, if it has one; what it throws becomes a JobFailure. Of a calibration that was abandoned meanwhile
  /// only what `isLasting` counts: what is saved, or should have been.
  using Job = std::function<std::optional<JobResult>(bool& isLasting)>;
  void putBackUnsaved(); // the worker's
  void give(Job job);    // has the worker do it

  CalibrationContext context_;
  std::filesystem::path folder_;
  std::atomic<std::uint64_t> abandoned_{0};        // so many calibrations
  std::optional<std::string> keysToPutBack_;       // the worker's, while what is in effect is not saved
  StoredResult before_;                            // the worker's
  bool isChecked_ = false;                         // the worker's
  std::array<std::shared_ptr<Round>, 2> sessions_; // belong to the worker
  std::mutex resultsMutex_;
  std::deque<QueuedResult> results_;
  Latest<ProcessedCaptures> processed_;
  ProcessedCaptures processedSoFar_;       // the worker's
  Worker worker_{Worker::AtEnd::allTasks}; // last: it uses the others
};

} // namespace naocal
