#include "brain/CalibrationRunner.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>

namespace naocal {
namespace {

using Phase = CalibrationState::Phase;

std::string kindNames() {
  std::string names;
  for (const CalibrationKind& kind : calibrationKinds()) {
    names += fmt::format("\"{}\", ", kind.run);
  }
  return names + "\"poses\", \"undo\" or \"\"";
}

} // namespace

CalibrationRunner::CalibrationRunner(CalibrationSurroundings surroundings)
    : Module{"CalibrationRunner"}, work_{std::move(surroundings)} {}

void CalibrationRunner::parametersChanged() {
  kinds_ = calibrationKinds();
  const bool isGiven = run_.takeGiven(), isNew = *run_ != std::exchange(runBefore_, *run_);
  const bool counts = isGiven && (state_->runs() ? *run_ != state_->kind : isNew);
  if (!counts) {
    return;
  }
  const CalibrationKind* kind = calibrationKind(*run_);
  if (state_->runs()) {
    fail("The calibration was ended; the robot goes back to its stand. Nothing was changed.");
  } else if (kind != nullptr) {
    start(*kind);
  } else if (*run_ == "undo") {
    state_ = CalibrationState{.kind = *run_, .questionNumber = state_->questionNumber};
    enter(Phase::preparing, "What the last calibration saved is being taken back.");
    work_.undo();
  } else if (*run_ == "poses") {
    startAskedPoses();
  } else if (!run_->empty()) {
    enter(Phase::failed, fmt::format("There is no calibration \"{}\"; expected {}.", *run_, kindNames()));
  }
}

void CalibrationRunner::start(const CalibrationKind& kind) {
  kind_ = &kind;
  state_ = CalibrationState{.kind = kind.run, .questionNumber = state_->questionNumber};
  const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  const CalibrationSurroundings& surroundings = work_.surroundings();
  work_.begin(surroundings.recordings / fmt::format("{:%Y-%m-%d_%H-%M-%S}", fmt::gmtime(now)));
  rounds_ = {};
  round_ = 0;
  poseTime_.reset();
  shownPoses_ = ShownPoses{};
  shownCaptures_ = std::vector<ShownCapture>{};
  shownOutcome_ = ShownOutcome{};
  ask(PoseRequest::Kind::home, "The stand", {});
  enter(Phase::goingHome, "The robot goes to its stand.");
}

void CalibrationRunner::startAskedPoses() {
  if (askedPoses_->feet.empty()) {
    return enter(Phase::failed, "No poses were asked for: expected a pose file's content in the parameter \"poses\", "
                                "with poses on one foot.");
  }
  askedKind_ = {"poses", "Poses", "The poses that were asked for.", askedPoses_->feet};
  start(askedKind_);
}

void CalibrationRunner::enter(Phase phase, const std::string& sentence) {
  CalibrationState& state = state_.edit();
  state.phase = phase;
  state.sentence = sentence;
  state.question = phase == Phase::waiting ? sentence : "";
  if (!state.runs()) {
    state.secondsLeft.reset();
  }
}

void CalibrationRunner::fail(const std::string& sentence) {
  work_.abandon();
  followed_.reset(); // no look that was set at the same time
  ask(PoseRequest::Kind::home, "", {});
  enter(Phase::failed, sentence);
}

void CalibrationRunner::ask(PoseRequest::Kind kind, const std::string& name, std::vector<CompensatedAngles> points,
                            bool held) {
  request_.edit().write({++requests_, kind, name, std::move(points), held});
}

void CalibrationRunner::cycle() {
  state_.edit();
  if (++cycles_ % 30 == 0) { // what hardly changes: who comes to look later is told within a second
    kinds_.edit();
    shownPoses_.edit();
    shownCaptures_.edit();
    shownOutcome_.edit();
  }
  watchPlayer();
  takeFound();
  follow(*look_);
  const bool arrived = player_.request == requests_ && player_.done;
  switch (state_->phase) {
  case Phase::waiting:
    return *confirmed_ == state_->questionNumber ? go() : void();
  case Phase::goingHome:
    return arrived && player_.atHome ? endStep() : void();
  case Phase::moving:
    waitingSince_ = pictureSince_ = Clock::now();
    return arrived ? enter(Phase::collecting, state_->sentence) : void();
  case Phase::collecting:
    return collect();
  default:
    return;
  }
}

void CalibrationRunner::watchPlayer() {
  if (const PlayerState* update = playerUpdates_->take()) {
    const bool pressed = update->presses > player_.presses;
    player_ = *update;
    playerKnown_ = true;
    if (pressed) {
      chestPressed();
    }
  }
  if (state_->runs() && player_.request == requests_ && !player_.reason.empty()) {
    work_.abandon();
    enter(Phase::failed, fmt::format("The calibration ended. {}", player_.reason));
  }
}

void CalibrationRunner::chestPressed() {
  const CalibrationKind* kind = calibrationKind(*chestStarts_);
  if (state_->phase == Phase::waiting) {
    go();
  } else if (!state_->runs() && kind != nullptr) {
    start(*kind);
  }
}

void CalibrationRunner::follow(const WantedLook& look) {
  if (!followed_ || state_->runs()) { // what a file says moves nothing, nor what is set while something else runs
    followed_ = look;
  }
  const bool isLooking = requests_ > 0 && lookRequest_ == requests_;
  const bool standsOnBoth = isLooking || player_.atHome || player_.phase == PlayerState::Phase::off ||
                            player_.phase == PlayerState::Phase::fallen; // else it is on its way back
  if (!playerKnown_ || player_.request != requests_ || !standsOnBoth || look == *followed_) {
    return;
  }
  if (look.active) {
    ask(PoseRequest::Kind::go, "Looking there", {lookingFrom(player_.home, look.yaw, look.pitch)});
    lookRequest_ = requests_;
  } else if (followed_->active) {
    ask(PoseRequest::Kind::home, "The stand", {});
  }
  followed_ = look;
}

} // namespace naocal
