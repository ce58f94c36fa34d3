#include "brain/CalibrationJobs.hpp"

#include "brain/CalibrationInputs.hpp"
#include "brain/CalibrationScript.hpp"
#include "calibration/result/Plausibility.hpp"
#include "dialects/SavedCalibration.hpp"
#include "effects/Catalogue.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"

#include <deque>
#include <exception>
#include <fmt/format.h>
#include <map>
#include <utility>

namespace naocal {
namespace {

constexpr double maxRemainingError = 0.5; // largest remaining share of the error; above it the calibration is not kept

/// Throws InputError for offsets and camera mounts that no robot has, which indicate inconsistent captures.
void requirePlausible(const std::vector<EffectiveOffset>& offsets, const StoredResult& mounts) {
  std::map<std::string, double> values;
  for (const EffectiveOffset& offset : offsets) {
    values[fmt::format("{}@{}.o", effectName::jointOffset, offset.joint)] = offset.value;
  }
  for (const auto& [name, value] : mounts.values) {
    if (name.starts_with(effectName::cameraRotation)) {
      values[name] = value;
    }
  }
  const std::vector<std::string> reasons = listImplausible(values);
  if (!reasons.empty()) {
    throw InputError{fmt::format("{}. Nothing was changed. Look whether all boards are those of the configuration and "
                                 "lie still",
                                 reasons.front())};
  }
}

/// Poses of each foot, one foot after the other; stances are numbered in this order.
CalibrationRound legRound(const std::deque<LegRoundPlanner>& legs, RoundOptions options) {
  CalibrationRound round;
  int stance = 0;
  for (const LegRoundPlanner& leg : legs) {
    const CalibrationRound onFoot = leg.planRound(options, stance++);
    round.insert(round.end(), onFoot.begin(), onFoot.end());
  }
  return round;
}

} // namespace

CalibrationJobs::CalibrationJobs(CalibrationContext context)
    : context_{std::move(context)}, runs_{context_.runs, context_.configuration} {
  saveCalibrationTogether(context_.configuration);
  worker_.enqueue([this] { runs_.publishNewest(); });
}

void CalibrationJobs::begin(std::filesystem::path folder, std::string kind) {
  folder_ = std::move(folder);
  kind_ = std::move(kind);
  sessions_ = {};
  give([this, folder = folder_](bool&) {
    before_ = readConfiguredCalibration(context_.configuration);
    isChecked_ = false;
    context_.configuration.writeTo(folder / "configuration");
    return std::nullopt;
  });
}

void CalibrationJobs::planLegs(LegRounds legs) {
  give([legs = std::move(legs), &drawing = context_.drawing, folder = folder_, files = context_.files](bool&) mutable {
    std::filesystem::path file = files / "poses" / (drawing.model + ".json");
    if (!legs.asked.empty()) { // a requested pose file is stored with the recording
      file = folder / "poses.json";
      writeAtomically(file, legs.asked);
    }
    const PoseFile poses = readPoseFile(file, drawing);
    std::deque<LegRoundPlanner> each;
    for (const SupportFoot foot : legs.feet) {
      each.emplace_back(drawing, poses, foot, legs.home);
    }
    PlannedRounds planned;
    planned.rounds[0] = legRound(each, legs.options);
    ++legs.options.seed;
    legs.options.poses = static_cast<std::size_t>(legs.checkPoses);
    planned.rounds[1] = legRound(each, legs.options);
    return planned;
  });
}

void CalibrationJobs::openRound(std::size_t round, CaptureSet header) {
  sessions_[round] = std::make_shared<Round>();
  give([session = sessions_[round], &drawing = context_.drawing, header = std::move(header),
        folder = folder_ / (round == 0 ? "first" : "second"), files = context_.files](bool&) {
    session->session.emplace(drawing, header, folder, loadCalibrationModel(files, drawing));
    return std::nullopt;
  });
}

void CalibrationJobs::processCapture(std::size_t round, Capture capture, PublishedCapture shown, CameraFrame frame) {
  give([this, session = sessions_[round], folder = folder_, capture = std::move(capture), shown = std::move(shown),
        frame = std::move(frame)](bool&) mutable {
    if (processedSoFar_.folder != folder) {
      processedSoFar_ = {folder, {}};
    }
    shown.corners = 0;
    for (const BoardCorners& board : session->session.value().record(capture, frame)) {
      shown.boards.push_back(board.board);
      *shown.corners += static_cast<int>(board.ids.size());
    }
    processedSoFar_.captures.push_back(std::move(shown));
    processed_.write(processedSoFar_);
    return std::nullopt;
  });
}

void CalibrationJobs::solve(bool onlyHead) {
  give([this, session = sessions_[0], onlyHead, abandoned = abandoned_.load()](bool&) -> std::optional<JobResult> {
    const CalibrationRecorder::Solution solved = session->session.value().solve();
    const std::vector<EffectiveOffset> offsets = onlyHead ? headOffsets(solved.offsets) : solved.offsets;
    PublishedOutcome outcome = summarizeOutcome(before_, offsets, processedSoFar_.captures);
    for (const Finding& finding : solved.findings) {                // `summarizeOutcome` says what was not learned
      const bool isOfTask = finding.id == "weak:task" && !onlyHead; // floor height is known only if legs are calibrated
      const bool isTold = finding.kind() != "weak" && finding.kind() != "not-learned";
      if (isOfTask || isTold || finding.id == "weak:approach") {
        outcome.warnings.push_back(finding.sentence);
      }
    }
    outcome.before = snapshotCalibration(context_.configuration);
    if (abandoned != abandoned_) {
      return std::nullopt;
    }
    requirePlausible(learnedOffsets(offsets), solved.result);
    applyCalibration(learnedOffsets(offsets), solved.result, context_.configuration);
    keysToPutBack_ = outcome.before;
    return AppliedCalibration{std::move(outcome)};
  });
}

void CalibrationJobs::check() {
  give([this, session = sessions_[1], folder = folder_, kind = kind_, abandoned = abandoned_.load()](bool& isLasting) {
    const CalibrationRecorder::ErrorComparison error =
        session->session.value().compareErrors(before_, readConfiguredCalibration(context_.configuration));
    isLasting = abandoned == abandoned_ && error.after <= maxRemainingError * error.before;
    if (isLasting) {
      saveCalibration(context_.configuration);
      keysToPutBack_.reset();
    }
    putBackUnsaved();
    isChecked_ = true;
    runs_.recordCalibration({kind, folder, error,
                             isLasting                                              ? RunOutcome::kept
                             : abandoned == abandoned_ && error.before <= goodError ? RunOutcome::unneeded
                                                                                    : RunOutcome::takenBack});
    return CheckedCalibration{error, isLasting};
  });
  give([this, session = sessions_[0]](bool&) -> std::optional<JobResult> {
    if (!isChecked_) {
      return std::nullopt;
    }
    try {
      return ModelDiagnosis{session->session.value().diagnose()};
    } catch (const std::exception& error) {
      return ModelDiagnosis{fmt::format("How well the model fits could not be told: {}.", error.what())};
    }
  });
}

void CalibrationJobs::putBackUnsaved() {
  if (!keysToPutBack_) {
    return;
  }
  const bool wasSaved = isCalibrationSaved(context_.configuration); // by another client, before the check
  restoreCalibration(*std::exchange(keysToPutBack_, std::nullopt), context_.configuration);
  if (wasSaved) {
    saveCalibration(context_.configuration);
  }
}

void CalibrationJobs::abandon() {
  ++abandoned_;
  give([this](bool&) {
    putBackUnsaved();
    return std::nullopt;
  });
}

void CalibrationJobs::undo() {
  give([this](bool& isLasting) {
    const std::map<std::string, double> before = readConfiguredOffsets(context_.configuration);
    undoCalibration(context_.configuration);
    isLasting = true;
    runs_.recordUndo(before);
    return CalibrationUndone{};
  });
}

void CalibrationJobs::recordFall() {
  worker_.enqueue([this] { runs_.recordFall(); });
}

void CalibrationJobs::recordSaves() {
  const std::size_t count = context_.configuration.saveCount();
  if (saveCount_ == count) {
    return;
  }
  const bool isFirst = !std::exchange(saveCount_, count);
  worker_.enqueue([this, isFirst] {
    if (isFirst) {
      runs_.noteConfigured();
    } else if (!keysToPutBack_) { // what a calibration has applied is recorded with it
      runs_.recordSaved();
    }
  });
}

void CalibrationJobs::finish() {
  ++abandoned_;
  worker_.waitUntilIdle();
}

std::optional<CalibrationJobs::JobResult> CalibrationJobs::takeResult() {
  const std::lock_guard lock{resultsMutex_};
  while (!results_.empty()) {
    QueuedResult next = std::move(results_.front());
    results_.pop_front();
    if (next.folder == folder_) {
      return std::move(next.result);
    }
  }
  return std::nullopt;
}

const std::vector<PublishedCapture>* CalibrationJobs::takeProcessed() {
  const ProcessedCaptures* processed = processed_.take();
  return processed != nullptr && processed->folder == folder_ ? &processed->captures : nullptr;
}

void CalibrationJobs::give(Job job) {
  worker_.enqueue([this, folder = folder_, abandoned = abandoned_.load(), job = std::move(job)] {
    bool isLasting = false;
    std::optional<JobResult> result;
    try {
      result = job(isLasting);
    } catch (const std::exception& error) {
      result = JobFailure{error.what()};
    }
    if (result && (isLasting || abandoned == abandoned_)) {
      const std::lock_guard lock{resultsMutex_};
      results_.push_back({folder, *std::move(result)});
    }
  });
}

} // namespace naocal
