#include "brain/CalibrationRunner.hpp"
#include "math/Angles.hpp"

#include <algorithm>
#include <fmt/format.h>

/// The rounds of a calibration, and what follows from what its work finds.
namespace naocal {
namespace {

using Phase = CalibrationState::Phase;

constexpr double goodError = 1.5; // [px]; 2 cm on the floor, two metres away

} // namespace

void CalibrationRunner::prepare() {
  enter(Phase::preparing, "The ways between the poses are being checked.");
  RoundOptions options{*repeats_, radians(*approach_), 0, *orderSeed_};
  if (kind_->feet.front() == SupportFoot::both) {
    constexpr double nearer = 0.7; // to check, other places than those that were calibrated with
    rounds_[0] = headRound(player_.home, *yaws_, *pitches_, 1, options);
    ++options.seed;
    rounds_[1] = headRound(player_.home, *yaws_, *pitches_, nearer, options);
    return startRound();
  }
  work_.plan({kind_->feet, options, *checkPoses_, player_.home, kind_ == &askedKind_ ? askedPoses_->content : ""});
}

void CalibrationRunner::startRound() {
  const CalibrationRound& round = rounds_[round_];
  step_ = 0;
  state_.edit().pose = 0;
  state_.edit().poses = static_cast<int>(
      std::count_if(round.begin(), round.end(), [](const CalibrationStep& step) { return step.pictures > 0; }));
  roundStart_.reset();
  work_.open(round_, header());
  nextStep();
}

void CalibrationRunner::take(const Capture& capture) {
  ShownCapture shown{++state_.edit().captures, static_cast<int>(round_), capture.pose, capture.camera, {}, {}};
  shownCaptures_.edit().push_back(shown);
  work_.look(round_, capture, std::move(shown), picture_->frame);
}

void CalibrationRunner::endRound() {
  ask(PoseRequest::Kind::home, "The stand", {}); // it is there, and can be let go
  if (kind_ == &askedKind_) {
    return enter(Phase::finished, fmt::format("All poses were taken; what was seen lies in {} on the robot.",
                                              (work_.folder() / "first").string()));
  }
  if (round_ == 0) {
    enter(Phase::solving, "The captures are being solved.");
    work_.solve(kind_->feet.front() == SupportFoot::both);
  } else {
    enter(Phase::checking, "The second round is being compared with what was solved.");
    work_.check();
  }
}

void CalibrationRunner::takeFound() {
  if (const std::vector<ShownCapture>* looked = work_.looked()) {
    std::copy(looked->begin(), looked->end(), shownCaptures_.edit().begin());
  }
  while (auto found = work_.found()) {
    take(std::move(*found));
  }
}

void CalibrationRunner::take(CalibrationWork::Finding found) {
  if (found.isUndone) {
    shownOutcome_ = ShownOutcome{};
    enter(Phase::finished, "What the last calibration saved was taken back.");
  } else if (!found.diagnosis.empty()) {
    shownOutcome_.edit().diagnosis = found.diagnosis;
  } else if (!found.problem.empty()) {
    const bool isUndo = state_->kind == "undo";
    isUndo || !state_->runs()
        ? enter(Phase::failed, fmt::format("{}{}.", isUndo ? "Nothing was taken back: " : "", found.problem))
        : fail(fmt::format("The calibration ended: {}.", found.problem));
  } else if (found.error && (found.isKept || state_->runs())) {
    tellError(*found.error, found.isKept);
  } else if (found.rounds && state_->runs()) {
    rounds_ = std::move(*found.rounds);
    startRound();
  } else if (found.isApplied && state_->runs()) {
    shownOutcome_ = *found.outcome;
    round_ = 1;
    startRound();
  }
}

void CalibrationRunner::tellError(const CalibrationSession::Error& error, bool isKept) {
  state_.edit().errorBefore = error.before;
  state_.edit().errorAfter = error.after;
  const std::string errors =
      fmt::format("from {:.1f} to {:.1f} pixels in corners that were not calibrated with", error.before, error.after);
  if (isKept) {
    enter(Phase::finished,
          fmt::format("The measured error fell {}. The calibration is saved; it can be undone.", errors));
  } else if (error.before <= goodError) {
    enter(Phase::finished,
          fmt::format("The robot was well calibrated already (the measured error went {}), so it keeps "
                      "what it had.",
                      errors));
  } else {
    enter(Phase::failed,
          fmt::format("The measured error went {}: it did not fall by half, so the calibration was taken "
                      "back, and nothing was saved. Something else is off as well: calibrate the legs, or look at the "
                      "recording with 'naocal diagnose'.",
                      errors));
  }
}

CaptureSet CalibrationRunner::header() const {
  CaptureSet set;
  set.model = work_.surroundings().drawing.model;
  set.headId = work_.surroundings().identity.headId;
  set.bodyId = work_.surroundings().identity.bodyId;
  set.jointNames = {jointNames.begin(), jointNames.end()};
  for (const auto& [name, belief] : *cameras_) {
    set.cameras[name] = belief.intrinsics;
  }
  set.boards = boards_->boards;
  for (std::size_t foot = 0; foot < kind_->feet.size(); ++foot) {
    set.stances.push_back({static_cast<int>(foot), kind_->feet[foot], std::nullopt});
  }
  return set;
}

} // namespace naocal
