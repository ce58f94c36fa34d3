#include "brain/CalibrationRunner.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

using Phase = CalibrationState::Phase;

} // namespace

CalibrationRunner::CalibrationRunner(CalibrationSurroundings surroundings)
    : Module{"CalibrationRunner"}, surroundings_{std::move(surroundings)} {}

void CalibrationRunner::parametersChanged() {
  const bool changed = configured_ && *run_ != asked_;
  asked_ = *run_;
  configured_ = true;
  if (!changed) {
    return;
  }
  const Phase phase = state_->phase;
  const bool runs = phase != Phase::idle && phase != Phase::finished && phase != Phase::failed;
  if (runs) {
    ask(PoseRequest::Kind::home, "", {});
    enter(Phase::failed, "The calibration was ended; the robot goes back to its stand. Nothing more was changed.");
  } else if (*run_ == "head") {
    start();
  } else if (!run_->empty()) {
    enter(Phase::failed, fmt::format("There is no calibration \"{}\"; expected \"head\".", *run_));
  }
}

void CalibrationRunner::start() {
  state_ = CalibrationState{};
  const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  folder_ = surroundings_.recordings / fmt::format("{:%Y-%m-%d_%H-%M-%S}", fmt::gmtime(now));
  first_ = second_ = nullptr;
  ask(PoseRequest::Kind::home, "The stand", {});
  state_.edit().phase = Phase::goingHome;
  state_.edit().sentence = "The robot goes to its stand.";
}

void CalibrationRunner::enter(Phase phase, const std::string& sentence) {
  state_.edit().phase = phase;
  state_.edit().sentence = sentence;
  state_.edit().secondsLeft.reset();
}

void CalibrationRunner::ask(PoseRequest::Kind kind, const std::string& name, std::vector<CompensatedAngles> points) {
  request_.edit().write({++requests_, kind, name, std::move(points)});
}

void CalibrationRunner::cycle() {
  state_.edit();
  watchPlayer();
  takeFinding();
  switch (state_->phase) {
  case Phase::goingHome:
    if (player_.request == requests_ && player_.done && player_.atHome) {
      goOn();
    }
    return;
  case Phase::moving:
    if (player_.request == requests_ && player_.done) {
      state_.edit().phase = Phase::collecting;
      taken_ = {};
    }
    return;
  case Phase::collecting:
    return collect();
  default:
    return;
  }
}

void CalibrationRunner::watchPlayer() {
  if (const PlayerState* update = playerUpdates_->take()) {
    player_ = *update;
  }
  const bool awaited =
      state_->phase == Phase::goingHome || state_->phase == Phase::moving || state_->phase == Phase::collecting;
  if (awaited && player_.request == requests_ && !player_.reason.empty()) {
    enter(Phase::failed, fmt::format("The calibration ended. {}", player_.reason));
  }
}

void CalibrationRunner::nextPose() {
  const auto pose = static_cast<std::size_t>(state_->pose);
  if (pose == poses_.size()) {
    ask(PoseRequest::Kind::home, "The stand", {});
    enter(Phase::goingHome, "All pictures of this round are taken; the robot goes back to its stand.");
    return;
  }
  ask(PoseRequest::Kind::go, fmt::format("Pose {}", pose + 1), {poses_[pose]});
  state_.edit().phase = Phase::moving;
  state_.edit().sentence = fmt::format("Pose {} of {}.", pose + 1, poses_.size());
}

void CalibrationRunner::collect() {
  if (!picture_->isNew || picture_->stillFor < *settleTime_ || picture_->frame.time < player_.doneAt) {
    return;
  }
  const TimePoint now = picture_->frame.time;
  roundStart_ = roundStart_.value_or(now);
  Capture capture = picture_->capture;
  int& count = taken_[capture.camera];
  if (count < *repeats_) {
    capture.pose = fmt::format("H{:02}", state_->pose);
    capture.repeat = count++;
    capture.supportFoot = SupportFoot::both;
    ++state_.edit().captures;
    give([round = second_ ? second_ : first_, capture, frame = picture_->frame](Finding&) {
      round->session.value().add(capture, frame);
    });
  }
  if (taken_["top"] >= *repeats_ && taken_["bottom"] >= *repeats_) {
    CalibrationState& state = state_.edit();
    ++state.pose;
    if (state.pose > 1) { // from the first pose's pictures to these
      state.secondsLeft = seconds(now - *roundStart_) / (state.pose - 1) * (state.poses - state.pose);
    }
    nextPose();
  }
}

} // namespace naocal
