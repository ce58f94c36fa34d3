#include "brain/CalibrationJobs.hpp"

#include "brain/CalibrationInputs.hpp"
#include "brain/CalibrationScript.hpp"
#include "brain/SavedCalibration.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"

#include <cmath>
#include <deque>
#include <exception>
#include <fmt/format.h>
#include <utility>

namespace naocal {
namespace {

constexpr double leastGain = 0.5;          // what a calibration leaves of the error at most, to be kept
constexpr double mostOffset = radians(20); // of any NAO: 11 degrees have been seen

/// Throws InputError for offsets that no robot has: captures that do not belong together.
void requirePlausible(const std::vector<ShownOffset>& offsets) {
  for (const ShownOffset& offset : offsets) {
    if (!(std::abs(offset.value) <= mostOffset)) {
      throw InputError{fmt::format("{} would be off by {:.0f} degrees, which no robot's is. Nothing was changed. Look "
                                   "whether all boards are those of the configuration and lie still",
                                   offset.joint, degrees(offset.value))};
    }
  }
}

/// Each foot's poses, one foot after the other; each time that the robot steps onto one is a stance.
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

CalibrationJobs::CalibrationJobs(CalibrationContext context) : context_{std::move(context)} {
  saveCalibrationTogether(context_.configuration);
}

void CalibrationJobs::begin(std::filesystem::path folder) {
  folder_ = std::move(folder);
  sessions_ = {};
  give([this, folder = folder_](JobResult&) {
    before_ = readConfiguredCalibration(context_.configuration);
    isChecked_ = false;
    context_.configuration.writeTo(folder / "configuration");
  });
}

void CalibrationJobs::planLegs(LegRounds legs) {
  give([legs = std::move(legs), &drawing = context_.drawing, folder = folder_,
        files = context_.files](JobResult& finding) mutable {
    std::filesystem::path file = files / "poses" / (drawing.model + ".json");
    if (!legs.asked.empty()) { // what was asked for stays with what was recorded
      file = folder / "poses.json";
      writeAtomically(file, legs.asked);
    }
    const PoseFile poses = readPoseFile(file, drawing);
    std::deque<LegRoundPlanner> each;
    for (const SupportFoot foot : legs.feet) {
      each.emplace_back(drawing, poses, foot, legs.home);
    }
    finding.rounds.emplace();
    finding.rounds->at(0) = legRound(each, legs.options);
    ++legs.options.seed;
    legs.options.poses = static_cast<std::size_t>(legs.checkPoses);
    finding.rounds->at(1) = legRound(each, legs.options);
  });
}

void CalibrationJobs::openRound(std::size_t round, CaptureSet header) {
  sessions_[round] = std::make_shared<Round>();
  give([session = sessions_[round], &drawing = context_.drawing, header = std::move(header),
        folder = folder_ / (round == 0 ? "first" : "second"), files = context_.files](JobResult&) {
    session->session.emplace(drawing, header, folder, loadCalibrationModel(files, drawing));
  });
}

void CalibrationJobs::processCapture(std::size_t round, Capture capture, PublishedCapture shown, CameraFrame frame) {
  give([this, session = sessions_[round], folder = folder_, capture = std::move(capture), shown = std::move(shown),
        frame = std::move(frame)](JobResult&) mutable {
    if (lookedAt_.folder != folder) {
      lookedAt_ = {folder, {}};
    }
    shown.corners = 0;
    for (const BoardCorners& board : session->session.value().record(capture, frame)) {
      shown.boards.push_back(board.board);
      *shown.corners += static_cast<int>(board.ids.size());
    }
    lookedAt_.captures.push_back(std::move(shown));
    looked_.write(lookedAt_);
  });
}

void CalibrationJobs::solve(bool onlyHead) {
  give([this, session = sessions_[0], onlyHead, abandoned = abandoned_.load()](JobResult& finding) {
    const CalibrationRecorder::Solution solved = session->session.value().solve();
    const std::vector<ShownOffset> offsets = onlyHead ? headOffsets(solved.offsets) : solved.offsets;
    finding.outcome = summarizeOutcome(before_, offsets, lookedAt_.captures);
    for (const Warning& warning : solved.warnings) { // only with the legs it is known where the floor is
      if (warning.about == Warning::About::fit || (warning.about == Warning::About::floor && !onlyHead)) {
        finding.outcome->warnings.push_back(warning.sentence);
      }
    }
    const std::string keys = snapshotCalibration(context_.configuration);
    finding.outcome->before = keys;
    if (abandoned == abandoned_) {
      requirePlausible(learnedOffsets(offsets));
      applyCalibration(learnedOffsets(offsets), solved.result, context_.configuration);
      keysToPutBack_ = keys;
      finding.isApplied = true;
    }
  });
}

void CalibrationJobs::check() {
  give([this, session = sessions_[1], abandoned = abandoned_.load()](JobResult& finding) {
    finding.error = session->session.value().compareErrors(before_, readConfiguredCalibration(context_.configuration));
    finding.isKept = abandoned == abandoned_ && finding.error->after <= leastGain * finding.error->before;
    if (finding.isKept) {
      saveCalibration(context_.configuration);
      keysToPutBack_.reset();
    }
    putBackUnsaved();
    isChecked_ = true;
  });
  give([this, session = sessions_[0]](JobResult& finding) {
    if (!isChecked_) {
      return;
    }
    try {
      finding.diagnosis = session->session.value().diagnose();
    } catch (const std::exception& error) {
      finding.diagnosis = fmt::format("How well the model fits could not be told: {}.", error.what());
    }
  });
}

void CalibrationJobs::putBackUnsaved() {
  if (!keysToPutBack_) {
    return;
  }
  const bool wasSaved = isCalibrationSaved(context_.configuration); // by somebody, unchecked
  restoreCalibration(*std::exchange(keysToPutBack_, std::nullopt), context_.configuration);
  if (wasSaved) {
    saveCalibration(context_.configuration);
  }
}

void CalibrationJobs::abandon() {
  ++abandoned_;
  give([this](JobResult&) { putBackUnsaved(); });
}

void CalibrationJobs::undo() {
  give([this](JobResult& finding) {
    undoCalibration(context_.configuration);
    finding.isUndone = true;
  });
}

void CalibrationJobs::finish() {
  ++abandoned_;
  worker_.waitUntilIdle();
}

std::optional<CalibrationJobs::JobResult> CalibrationJobs::takeResult() {
  const std::lock_guard lock{findingsMutex_};
  while (!findings_.empty()) {
    JobResult finding = std::move(findings_.front());
    findings_.pop_front();
    if (finding.folder == folder_) {
      return finding;
    }
  }
  return std::nullopt;
}

const std::vector<PublishedCapture>* CalibrationJobs::takeProcessed() {
  const ProcessedCaptures* looked = looked_.take();
  return looked != nullptr && looked->folder == folder_ ? &looked->captures : nullptr;
}

void CalibrationJobs::give(std::function<void(JobResult&)> task) {
  worker_.enqueue([this, folder = folder_, abandoned = abandoned_.load(), task = std::move(task)] {
    JobResult finding{.folder = folder};
    try {
      task(finding);
    } catch (const std::exception& error) {
      finding.problem = error.what();
    }
    const bool isWanted = abandoned == abandoned_ || finding.isKept || finding.isUndone;
    const bool isSomething = finding.rounds || finding.isApplied || finding.error || finding.isUndone ||
                             !finding.diagnosis.empty() || !finding.problem.empty();
    if (isWanted && isSomething) {
      const std::lock_guard lock{findingsMutex_};
      findings_.push_back(std::move(finding));
    }
  });
}

} // namespace naocal
