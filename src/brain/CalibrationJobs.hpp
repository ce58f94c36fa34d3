#pragma once

#include "brain/CalibrationRecorder.hpp"
#include "brain/CalibrationRuns.hpp"
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

/// Inputs of a calibration other than its parameters.
struct CalibrationContext {
  const Robot& drawing;
  RobotIdentity identity;
  Configuration& configuration;     // target of applied and saved results
  std::filesystem::path files;      // configuration folder, copied into recordings; has poses/V6.json, models/V6.json
  std::filesystem::path recordings; // parent folder; one new folder per calibration
  RunRecording runs = {};           // where calibrations, undos and falls are recorded
};

inline constexpr double goodError =
    1.5; // [px]; about 2 cm on the floor at 2 m; up to it a robot counts as well calibrated

/// Runs the slow jobs of a calibration on a worker thread, so that no cycle waits: planning ways between poses,
/// detecting boards, writing captures, solving, applying, comparing. Calls return at once and run in the order of
/// calls. Results are polled with `takeResult` and discarded once another calibration has begun.
class CalibrationJobs {
public:
  using Rounds = std::array<CalibrationRound, 2>; // [0] to calibrate, [1] to check

  explicit CalibrationJobs(CalibrationContext context);
  ~CalibrationJobs() { finish(); }
  const CalibrationContext& context() const { return context_; }

  /// Begins a calibration of this kind with output folder `folder`; copies the configuration into it and records the
  /// current calibration as the baseline.
  void begin(std::filesystem::path folder, std::string kind);
  const std::filesystem::path& folder() const { return folder_; }

  /// Poses on one foot at a time: from `asked` (a pose file's content), or from the configuration's pose file if
  /// `asked` is empty. The check round has `checkPoses` poses per foot.
  struct LegRounds {
    std::vector<SupportFoot> feet;
    RoundOptions options;
    int checkPoses;
    CompensatedAngles home;
    std::string asked;
  };
  void planLegs(LegRounds legs);

  /// Opens a round's recording; the following `processCapture` calls refer to it.
  void openRound(std::size_t round, CaptureSet header);
  void processCapture(std::size_t round, Capture capture, PublishedCapture shown, CameraFrame frame);

  /// Solves the first round and applies the result; `onlyHead` restricts the offsets to the neck.
  void solve(bool onlyHead);
  /// Compares the new and the previous calibration on the second round's captures; saves the new one if the error falls
  /// by half, otherwise restores the previous one. Then diagnoses the model fit on the first round.
  void check();
  /// Aborts the calibration: discards later results except saved ones, and restores a calibration that was applied but
  /// not saved.
  void abandon();
  /// Undoes the last saved calibration.
  void undo();
  /// Records that the robot has fallen.
  void recordFall();
  /// Records offsets that a client has saved. Call it in every cycle.
  void recordSaves();
  /// Waits until all jobs are done; an applied, unsaved calibration stays in effect.
  void finish();

  /// Results of jobs.
  struct PlannedRounds {
    Rounds rounds;
  };
  struct AppliedCalibration { // in effect, not saved
    PublishedOutcome outcome;
  };
  struct CheckedCalibration {
    CalibrationRecorder::ErrorComparison error;
    bool isKept; // true: saved; false: the previous calibration is restored
  };
  struct ModelDiagnosis {
    std::string sentence; // model fit, one or two sentences
  };
  struct CalibrationUndone {}; // the last saved calibration is undone
  struct JobFailure {
    std::string reason; // clause, inserted into a sentence
  };
  using JobResult = std::variant<PlannedRounds, AppliedCalibration, CheckedCalibration, ModelDiagnosis,
                                 CalibrationUndone, JobFailure>;
  /// The next result, in the order of jobs.
  std::optional<JobResult> takeResult();
  /// All captures processed so far, in order; nullptr if none were added since the last call.
  const std::vector<PublishedCapture>* takeProcessed();
  /// The newest runs of this robot; nullptr if none were added since the last call.
  const PublishedRuns* takeRuns() { return runs_.take(); }

private:
  /// A round's recording; created and used by the worker only.
  struct Round {
    std::optional<CalibrationRecorder> session;
  };
  struct ProcessedCaptures {
    std::filesystem::path folder;
    std::vector<PublishedCapture> captures;
  };
  struct QueuedResult {
    std::filesystem::path folder; // identifies the calibration
    JobResult result;
  };
  /// Returns a job's result, if any; an exception becomes a JobFailure. After `abandon`, only results with `isLasting`
  /// are reported: saved calibrations and undos.
  using Job = std::function<std::optional<JobResult>(bool& isLasting)>;
  void putBackUnsaved(); // worker only
  void give(Job job);    // enqueues it

  CalibrationContext context_;
  std::optional<std::size_t> saveCount_; // of the configuration, at the last `recordSaves`
  std::filesystem::path folder_;
  std::string kind_;
  std::atomic<std::uint64_t> abandoned_{0};        // number of abandoned calibrations
  std::optional<std::string> keysToPutBack_;       // worker only; set while an applied calibration is unsaved
  StoredResult before_;                            // worker only
  bool isChecked_ = false;                         // worker only
  std::array<std::shared_ptr<Round>, 2> sessions_; // contents: worker only
  std::mutex resultsMutex_;
  std::deque<QueuedResult> results_;
  Latest<ProcessedCaptures> processed_;
  ProcessedCaptures processedSoFar_;       // worker only
  CalibrationRuns runs_;                   // worker only, except takeRuns
  Worker worker_{Worker::AtEnd::allTasks}; // last: uses the members above
};

} // namespace naocal
