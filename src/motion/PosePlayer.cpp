#include "motion/PosePlayer.hpp"

#include "math/Angles.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

constexpr double longestSilence = 0.1; // [s]; after a longer gap between states, moved joints weaken the motors

bool isTouched(const Touch& touch) {
  return touch.headFront || touch.headMiddle || touch.headRear || touch.leftFootLeft || touch.leftFootRight ||
         touch.rightFootLeft || touch.rightFootRight || touch.leftHandBack || touch.leftHandLeft ||
         touch.leftHandRight || touch.rightHandBack || touch.rightHandLeft || touch.rightHandRight;
}

} // namespace

std::string PosePlayer::joints(const std::map<std::string, double>& stand) {
  for (const auto& [name, degrees] : stand) {
    if (!jointIndex(name) || !(std::abs(degrees) <= 180)) {
      return fmt::format("an angle in degrees for each joint, named as in {}; {} is none", jointNames[0], name);
    }
  }
  return "";
}

void PosePlayer::onParametersChanged() {
  home_ = {};
  for (const auto& [name, degrees] : *stand_) {
    home_[jointIndex(name).value()] = radians(degrees);
  }
  coupleHipYawPitch(home_);
  home_ = limits_.clamp(home_);
  state_.edit().home = home_;
}

void PosePlayer::cycle() {
  state_.edit();
  if (measured_->isNew) {
    now_ = measured_->state.time;
    motionTime_ += measured_->step();
    afterSilence(measured_->since);
    if (const PoseRequest* request = request_->take()) {
      look(*request);
    }
    watch(measured_->state);
    advance();
  }
  ending_.atRest = !isPlaying() || stage_ == Stage::atStand;
  forBrain_.edit().write(*state_);
}

void PosePlayer::enter(Stage stage) {
  using Phase = PlayerState::Phase;
  stage_ = stage;
  state_.edit().atHome = stage == Stage::atStand;
  switch (stage) {
  case Stage::off:
    state_.edit().phase = Phase::off;
    return;
  case Stage::fallen:
    state_.edit().phase = Phase::fallen;
    return;
  case Stage::atStand:
  case Stage::holding:
  case Stage::askingForHands:
    state_.edit().phase = Phase::holding;
    return;
  case Stage::goingOut:
  case Stage::goingHome:
    state_.edit().phase = Phase::moving;
  }
}

void PosePlayer::look(const PoseRequest& request) {
  PlayerState& state = state_.edit();
  state.request = request.number;
  state.done = false;
  waits_ = request.kind == PoseRequest::Kind::wait;
  state.held = waits_ ? state.held : request.held;
  switch (request.kind) {
  case PoseRequest::Kind::go:
    return go(request);
  case PoseRequest::Kind::home:
    return goHome("");
  case PoseRequest::Kind::wait:
    state.done = true;
    return;
  case PoseRequest::Kind::rest:
    stop(Stage::off, "");
    state.done = true;
  }
}

std::string PosePlayer::unreachable(const PoseRequest& request) const {
  for (const CompensatedAngles& point : request.points) {
    const CompensatedAngles reachable = limits_.clamp(point);
    for (std::size_t joint = 0; joint < jointCount; ++joint) {
      if (!(std::abs(point[joint] - reachable[joint]) < 1e-6)) { // also true for NaN
        return fmt::format("{} was refused: {} cannot take {:.1f} degrees there.", request.name, jointNames[joint],
                           degrees(point[joint]));
      }
    }
  }
  return request.points.empty() ? fmt::format("{} was refused: it names no angles.", request.name) : "";
}

bool PosePlayer::isNear(const CompensatedAngles& angles, const CompensatedAngles& point) const {
  for (std::size_t joint = 0; joint < jointCount; ++joint) {
    if (limits_.maxSpeed(joint) > 0 && std::abs(angles[joint] - point[joint]) > radians(*startDistance_)) {
      return false;
    }
  }
  return true;
}

bool PosePlayer::isReady(const std::string& who) {
  if (isPlaying()) {
    return true;
  }
  PlayerState& state = state_.edit();
  if (!isNear(*angles_, home_)) {
    state.reason = fmt::format("{} was refused: the robot is not at its stand. Put it there (each joint within {:.0f} "
                               "degrees) and start again.",
                               who, *startDistance_);
    return false;
  }
  desired_.edit().angles = *angles_;
  trail_ = {home_};
  state.needsHands = false;
  return true;
}

void PosePlayer::go(const PoseRequest& request) {
  state_.edit().reason = unreachable(request);
  if (!state_->reason.empty() || !isReady(request.name)) {
    return;
  }
  leaveMotion();
  extendTrail(desired_->angles);
  start(Stage::goingOut, request.points);
  state_.edit().needsHands |= request.held;
}

void PosePlayer::goHome(const std::string& reason) {
  state_.edit().reason = reason;
  if (!isReady("Going to the stand")) {
    return;
  }
  leaveMotion();
  waits_ = false;
  PlayerState& state = state_.edit();
  if (state.needsHands && !state.held) {
    enter(Stage::askingForHands);
    state.held = true;
    state.reason += fmt::format("{}Take hold of it by its trunk: its eyes are yellow. It steps back onto both feet in "
                                "{:.0f} s, or at once when its chest button is pressed.",
                                reason.empty() ? "" : " ", *handsTime_);
    handsUntil_ = now_ + fromSeconds(*handsTime_);
    return;
  }
  startHome();
}

void PosePlayer::startHome() {
  start(Stage::goingHome, {trail_.rbegin(), trail_.rend()});
}

void PosePlayer::start(Stage stage, std::vector<CompensatedAngles> points) {
  points_ = std::move(points);
  motion_.emplace(desired_->angles, points_, limits_, *speed_);
  motionTime_ = 0;
  enter(stage);
  desired_.edit().stiffness = *stiffness_;
}

void PosePlayer::leaveMotion() {
  if (!motion_) {
    return;
  }
  const auto passed = points_.begin() + static_cast<std::ptrdiff_t>(motion_->passedPoints(motionTime_));
  if (stage_ == Stage::goingHome) {
    trail_.assign(std::make_reverse_iterator(points_.end()), std::make_reverse_iterator(passed));
  } else {
    std::for_each(points_.begin(), passed, [this](const CompensatedAngles& point) { extendTrail(point); });
  }
  motion_.reset();
}

void PosePlayer::extendTrail(const CompensatedAngles& point) {
  const auto known = std::find(trail_.begin(), trail_.end(), point);
  trail_.erase(known == trail_.end() ? known : known + 1, trail_.end());
  if (known == trail_.end()) {
    trail_.push_back(point);
  }
}

void PosePlayer::stop(Stage stage, const std::string& reason) {
  leaveMotion();
  waits_ = false;
  PlayerState& state = state_.edit();
  state = {.request = state.request,
           .held = state.held,
           .needsHands = state.needsHands,
           .home = home_,
           .reason = reason,
           .presses = state.presses,
           .falls = state.falls};
  enter(stage);
  desired_.edit().stiffness = stage == Stage::off ? 0 : stage == Stage::fallen ? *fallenStiffness_ : *stiffness_;
}

void PosePlayer::advance() {
  PlayerState& state = state_.edit();
  DesiredPose& desired = desired_.edit();
  if (!isPlaying()) {
    desired.angles = *angles_; // no jump when the motors are switched on
    return;
  }
  if (stage_ == Stage::askingForHands && now_ >= handsUntil_) {
    startHome();
  }
  if (!motion_) {
    return;
  }
  desired.angles = motion_->at(motionTime_);
  state.progress = std::min(1.0, motionTime_ / motion_->duration());
  state.secondsLeft = std::max(0.0, motion_->duration() - motionTime_);
  if (motionTime_ >= motion_->duration()) {
    state.done = true;
    state.doneAt = now_;
    leaveMotion();
    enter(stage_ == Stage::goingHome ? Stage::atStand : Stage::holding);
    if (stage_ == Stage::atStand) {
      trail_ = {home_};
      state.needsHands = state.held = false;
    }
  }
}

void to_json(nlohmann::json& out, const DesiredPose& desired) {
  out = {{"angles", desired.angles.values}, {"stiffness", desired.stiffness}};
}

void PosePlayer::afterSilence(double length) {
  if (isPlaying() && length > longestSilence && !isNear(*angles_, desired_->angles)) {
    stop(Stage::fallen, fmt::format("Nothing was heard of the robot for {:.1f} s, and its joints were moved meanwhile, "
                                    "so the motors are weak. Stand the robot up and start again.",
                                    length));
  }
}

void PosePlayer::chestPressed() {
  const bool isOwn = isPlaying() && stage_ != Stage::atStand && !waits_;
  if (!isOwn) {
    ++state_.edit().presses;
  } else if (stage_ == Stage::askingForHands) {
    startHome();
  } else if (stage_ != Stage::goingHome) {
    goHome("The chest button was pressed: the robot goes back to its stand.");
  }
}

void PosePlayer::watch(const RobotState& state) {
  const bool newlyPressed = state.touch.chestButton && !wasPressed_;
  wasPressed_ = state.touch.chestButton;
  if (newlyPressed) {
    chestPressed();
  }
  if (!isPlaying()) {
    return;
  }
  const double tilt = degrees(std::max(std::abs(state.torsoAngles.x()), std::abs(state.torsoAngles.y())));
  const auto hot = std::max_element(state.temperature.begin(), state.temperature.end());
  const bool isOut = stage_ == Stage::goingOut || stage_ == Stage::holding;
  const std::string fault = isOut ? faults_.find({state, desired_->angles, *angles_, measured_->step()}) : "";
  if (!isOut) {
    faults_.reset();
  }
  if (tilt > *largestTilt_) {
    ++state_.edit().falls;
    stop(Stage::fallen, fmt::format("The torso is tilted by {:.0f} degrees, so the motors are weak. Stand the robot up "
                                    "and start again.",
                                    tilt));
  } else if (isTouched(state.touch) && motion_) {
    stop(Stage::holding, "The robot was touched and stopped. Press its chest button to have it go back to its stand.");
  } else if (ending_.asked && isOut) {
    goHome("The program is being ended: the robot goes back to its stand.");
  } else if (*hot > *hottest_ && isOut) {
    goHome(fmt::format("{} is {:.0f} degrees Celsius hot: the robot goes back to its stand. Let it cool down.",
                       jointNames[static_cast<std::size_t>(hot - state.temperature.begin())], *hot));
  } else if (!fault.empty()) {
    goHome(fault + " The robot goes back to its stand: look after it.");
  }
}

} // namespace naocal
