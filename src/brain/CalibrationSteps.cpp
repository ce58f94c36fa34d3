#include "brain/CalibrationRunner.hpp"
#include "brain/PictureDifference.hpp"

#include <algorithm>
#include <fmt/format.h>

/// The steps of a round: asking, going there, taking pictures when all is still.
namespace naocal {
namespace {

using Phase = CalibrationState::Phase;

constexpr std::chrono::seconds notWorthAWord{2};

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
  ask(PoseRequest::Kind::wait, "", {});
  state_.edit().questionNumber = std::max(state_->questionNumber, *confirmed_) + 1; // no old answer counts
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

void CalibrationRunner::waitFor(const char* what) {
  if (Clock::now() - waitingSince_ > notWorthAWord) {
    state_.edit().sentence = fmt::format("{} waits until {}.", rounds_[round_][step_].name, what);
  }
}

bool CalibrationRunner::takePicture() {
  const CalibrationStep& step = rounds_[round_][step_];
  const Capture& still = picture_->capture;
  if (picture_->isNew || picture_->isMoving) {
    pictureSince_ = Clock::now();
  }
  if (picture_->isMoving || (picture_->isNew && picture_->stillFor < *settleTime_)) {
    waitFor("the robot's joints and trunk are still: they tremble, or something moves the robot");
    return false;
  }
  if (!picture_->isNew || picture_->frame.time < player_.doneAt) {
    if (Clock::now() - pictureSince_ > notWorthAWord) {
      waitFor("the cameras give pictures");
    }
    return false;
  }
  roundStart_ = roundStart_.value_or(picture_->frame.time);
  int& count = taken_[still.camera];
  if (count == step.pictures) {
    waitFor(still.camera == "top" ? "the bottom camera gives pictures" : "the top camera gives pictures");
    return false;
  }
  if (!isStill(picture_->frame)) {
    waitFor("the picture is still: something moves before the camera");
    return false;
  }
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
  waitingSince_ = Clock::now();
  return true;
}

void CalibrationRunner::tellTimeLeft() {
  const auto left = [this](std::size_t round) {
    return std::count_if(rounds_[round].begin(), rounds_[round].end(),
                         [](const CalibrationStep& step) { return step.pictures > 0; });
  };
  CalibrationState& state = state_.edit();
  if (state.pose > 1) { // from the first pose's pictures to these
    poseTime_ = seconds(picture_->frame.time - *roundStart_) / (state.pose - 1);
  }
  if (poseTime_) {
    const auto later = round_ == 0 && kind_ != &askedKind_ ? left(1) : 0;
    state.secondsLeft = *poseTime_ * static_cast<double>(state.poses - state.pose + later);
  }
}

void CalibrationRunner::collect() {
  const CalibrationStep& step = rounds_[round_][step_];
  if (step.pictures > 0) {
    if (!takePicture() || taken_["top"] < step.pictures || taken_["bottom"] < step.pictures) {
      return;
    }
    ++state_.edit().pose;
    tellTimeLeft();
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
