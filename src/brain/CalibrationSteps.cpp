#include "brain/CalibrationRunner.hpp"
#include "brain/PictureDifference.hpp"

#include <fmt/format.h>

/// The steps of a round: asking, going there, taking pictures when all is still.
namespace naocal {
namespace {

using Phase = CalibrationState::Phase;

} // namespace

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
