#include "brain/CalibrationRunner.hpp"

#include "brain/PictureDifference.hpp"
#include "brain/SavedCalibration.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

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
    : Module{"CalibrationRunner"}, surroundings_{std::move(surroundings)} {}

void CalibrationRunner::parametersChanged() {
  const bool changed = configured_ && *run_ != asked_;
  asked_ = *run_;
  configured_ = true;
  kinds_ = calibrationKinds();
  if (!changed) {
    return;
  }
  const CalibrationKind* kind = calibrationKind(*run_);
  if (state_->runs()) {
    fail("The calibration was ended; the robot goes back to its stand. Nothing more was changed.");
  } else if (kind != nullptr) {
    start(*kind);
  } else if (*run_ == "undo") {
    undo();
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
  folder_ = surroundings_.recordings / fmt::format("{:%Y-%m-%d_%H-%M-%S}", fmt::gmtime(now));
  rounds_ = {};
  round_ = 0;
  sessions_ = {};
  before_ = configured(surroundings_.configuration);
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

void CalibrationRunner::undo() {
  try {
    takeBack(surroundings_.configuration);
    shownOutcome_ = ShownOutcome{};
    state_ = CalibrationState{.questionNumber = state_->questionNumber};
    enter(Phase::finished, "What the last calibration saved was taken back.");
  } catch (const std::exception& error) {
    enter(Phase::failed, fmt::format("Nothing was taken back: {}", error.what()));
  }
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
  takeFinding();
  takeLooked();
  follow(*look_);
  const bool arrived = player_.request == requests_ && player_.done;
  switch (state_->phase) {
  case Phase::waiting:
    return *confirmed_ == state_->questionNumber ? go() : void();
  case Phase::goingHome:
    return arrived && player_.atHome ? endStep() : void();
  case Phase::moving:
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
    enter(Phase::failed, fmt::format("The calibration ended. {}", player_.reason));
  }
}

void CalibrationRunner::chestPressed() {
  const CalibrationKind* kind = calibrationKind(*chestStarts_);
  if (state_->phase == Phase::waiting) {
    go();
  } else if (!state_->runs() && kind != nullptr) {
    asked_ = kind->run; // so that "" ends it
    start(*kind);
  }
}

void CalibrationRunner::follow(const WantedLook& look) {
  if (state_->runs() || !playerKnown_ || look == followed_) {
    return;
  }
  if (look.active) {
    ask(PoseRequest::Kind::go, "Looking there", {lookingFrom(player_.home, look.yaw, look.pitch)});
  } else if (followed_.active) {
    ask(PoseRequest::Kind::home, "The stand", {});
  }
  followed_ = look;
}

bool CalibrationRunner::isStill(const CameraFrame& frame) {
  const auto before = previous_.find(frame.camera);
  const auto one = before == previous_.end() ? std::nullopt : greyPicture(before->second), other = greyPicture(frame);
  previous_[frame.camera] = frame;
  return one && other && pictureDifference(*one, *other) <= *stillPicture_;
}

void CalibrationRunner::nextStep() {
  const CalibrationStep& step = rounds_[round_][step_];
  taken_ = {};
  previous_ = {};
  shownPoses_ = shownPoses(static_cast<int>(round_), rounds_[round_], step_);
  if (step.question.empty()) {
    return go();
  }
  ++state_.edit().questionNumber;
  enter(Phase::waiting, step.question);
}

void CalibrationRunner::go() {
  const CalibrationStep& step = rounds_[round_][step_];
  const bool home = step.points.empty();
  ask(home ? PoseRequest::Kind::home : PoseRequest::Kind::go, step.name, step.points, step.held);
  if (home) {
    enter(Phase::goingHome, "The robot goes back to its stand.");
  } else {
    enter(Phase::moving, fmt::format("{}; pictures were taken in {} of {}.", step.name, state_->pose, state_->poses));
  }
}

void CalibrationRunner::collect() {
  const CalibrationStep& step = rounds_[round_][step_];
  if (step.pictures > 0) {
    if (!picture_->isNew || picture_->stillFor < *settleTime_ || picture_->frame.time < player_.doneAt) {
      return;
    }
    roundStart_ = roundStart_.value_or(picture_->frame.time);
    const Capture& still = picture_->capture;
    int& count = taken_[still.camera];
    if (count < step.pictures && isStill(picture_->frame)) {
      Capture capture = step.taken;
      capture.repeat += count++;
      capture.time = still.time;
      capture.camera = still.camera;
      std::vector<double> approach = std::move(capture.joints.approach);
      capture.joints = still.joints;
      capture.joints.approach = std::move(approach);
      capture.imu = still.imu;
      capture.fsr = still.fsr;
      take(capture);
    }
    if (taken_["top"] < step.pictures || taken_["bottom"] < step.pictures) {
      return;
    }
    CalibrationState& state = state_.edit();
    ++state.pose;
    if (state.pose > 1) { // from the first pose's pictures to these
      state.secondsLeft = seconds(picture_->frame.time - *roundStart_) / (state.pose - 1) * (state.poses - state.pose);
    }
  }
  endStep();
}

void CalibrationRunner::endStep() {
  if (rounds_[0].empty()) { // at the stand, to begin with
    return prepare();
  }
  ++step_;
  return step_ < rounds_[round_].size() ? nextStep() : endRound();
}

} // namespace naocal
