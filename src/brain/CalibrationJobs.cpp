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
CalibrationRound legRound(const std::deque<LegPoses>& legs, RoundOptions options) {
  CalibrationRound round;
  int stance = 0;
  for (const LegPoses& leg : legs) {
    const CalibrationRound onFoot = leg.round(options, stance++);
    round.insert(round.end(), onFoot.begin(), onFoot.end());
  }
  return round;
}

} // namespace

CalibrationWork::CalibrationWork(CalibrationSurroundings surroundings) : surroundings_{std::move(surroundings)} {
  keepCalibrationTogether(surroundings_.configuration);
}

void CalibrationWork::begin(std::filesystem::path folder) {
  folder_ = std::move(folder);
  sessions_ = {};
  give([this, folder = folder_](Finding&) {
    before_ = configured(surroundings_.configuration);
    isChecked_ = false;
    surroundings_.configuration.writeTo(folder / "configuration");
  });
}

void CalibrationWork::plan(Legs legs) {
  give([legs = std::move(legs), &drawing = surroundings_.drawing, folder = folder_,
        files = surroundings_.files](Finding& finding) mutable {
    std::filesystem::path file = files / "poses" / (drawing.model + ".json");
    if (!legs.asked.empty()) { // what was asked for stays with what was recorded
      file = folder / "poses.json";
      writeAtomically(file, legs.asked);
    }
    const PoseFile poses = readPoseFile(file, drawing);
    std::deque<LegPoses> each;
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

void CalibrationWork::open(std::size_t round, CaptureSet header) {
  sessions_[round] = std::make_shared<Round>();
  give([session = sessions_[round], &drawing = surroundings_.drawing, header = std::move(header),
        folder = folder_ / (round == 0 ? "first" : "second"), files = surroundings_.files](Finding&) {
    session->session.emplace(drawing, header, folder, calibrationModel(files, drawing));
  });
}

void CalibrationWork::look(std::size_t round, Capture capture, ShownCapture shown, CameraFrame frame) {
  give([this, session = sessions_[round], folder = folder_, capture = std::move(capture), shown = std::move(shown),
        frame = std::move(frame)](Finding&) mutable {
    if (lookedAt_.folder != folder) {
      lookedAt_ = {folder, {}};
    }
    shown.corners = 0;
    for (const BoardCorners& board : session->session.value().add(capture, frame)) {
      shown.boards.push_back(board.board);
      *shown.corners += static_cast<int>(board.ids.size());
    }
    lookedAt_.captures.push_back(std::move(shown));
    looked_.write(lookedAt_);
  });
}

void CalibrationWork::solve(bool onlyHead) {
  give([this, session = sessions_[0], onlyHead, abandoned = abandoned_.load()](Finding& finding) {
    const CalibrationSession::Solved solved = session->session.value().solved();
    const std::vector<ShownOffset> offsets = onlyHead ? ofHead(solved.offsets) : solved.offsets;
    finding.outcome = shownOutcome(before_, offsets, lookedAt_.captures);
    for (const Warning& warning : solved.warnings) { // only with the legs it is known where the floor is
      if (warning.about == Warning::About::fit || (warning.about == Warning::About::floor && !onlyHead)) {
        finding.outcome->warnings.push_back(warning.sentence);
      }
    }
    const std::string keys = calibrationKeys(surroundings_.configuration);
    finding.outcome->before = keys;
    if (abandoned == abandoned_) {
      requirePlausible(learned(offsets));
      apply(learned(offsets), solved.result, surroundings_.configuration);
      keysToPutBack_ = keys;
      finding.isApplied = true;
    }
  });
}

void CalibrationWork::check() {
  give([this, session = sessions_[1], abandoned = abandoned_.load()](Finding& finding) {
    finding.error = session->session.value().error(before_, configured(surroundings_.configuration));
    finding.isKept = abandoned == abandoned_ && finding.error->after <= leastGain * finding.error->before;
    if (finding.isKept) {
      saveCalibration(surroundings_.configuration);
      keysToPutBack_.reset();
    }
    putBackUnsaved();
    isChecked_ = true;
  });
  give([this, session = sessions_[0]](Finding& finding) {
    if (!isChecked_) {
      return;
    }
    try {
      finding.diagnosis = session->session.value().diagnosed();
    } catch (const std::exception& error) {
      finding.diagnosis = fmt::format("How well the model fits could not be told: {}.", error.what());
    }
  });
}

void CalibrationWork::putBackUnsaved() {
  if (!keysToPutBack_) {
    return;
  }
  const bool wasSaved = isCalibrationSaved(surroundings_.configuration); // by somebody, unchecked
  putBack(*std::exchange(keysToPutBack_, std::nullopt), surroundings_.configuration);
  if (wasSaved) {
    saveCalibration(surroundings_.configuration);
  }
}

void CalibrationWork::abandon() {
  ++abandoned_;
  give([this](Finding&) { putBackUnsaved(); });
}

void CalibrationWork::undo() {
  give([this](Finding& finding) {
    undoCalibration(surroundings_.configuration);
    finding.isUndone = true;
  });
}

void CalibrationWork::finish() {
  ++abandoned_;
  worker_.finish();
}

std::optional<CalibrationWork::Finding> CalibrationWork::found() {
  const std::lock_guard lock{findingsMutex_};
  while (!findings_.empty()) {
    Finding finding = std::move(findings_.front());
    findings_.pop_front();
    if (finding.folder == folder_) {
      return finding;
    }
  }
  return std::nullopt;
}

const std::vector<ShownCapture>* CalibrationWork::looked() {
  const Looked* looked = looked_.take();
  return looked != nullptr && looked->folder == folder_ ? &looked->captures : nullptr;
}

void CalibrationWork::give(std::function<void(Finding&)> task) {
  worker_.add([this, folder = folder_, abandoned = abandoned_.load(), task = std::move(task)] {
    Finding finding{.folder = folder};
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
