#include "motion/PosePlayer.hpp"

#include "geometry/Angles.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

using Phase = PlayerState::Phase;

bool isTouched(const Touch& touch) {
  return touch.headFront || touch.headMiddle || touch.headRear || touch.leftFootLeft || touch.leftFootRight ||
         touch.rightFootLeft || touch.rightFootRight || touch.leftHandBack || touch.leftHandLeft ||
         touch.leftHandRight || touch.rightHandBack || touch.rightHandLeft || touch.rightHandRight;
}

} // namespace

void PosePlayer::parametersChanged() {
  home_ = {};
  for (const auto& [name, degrees] : *stand_) {
    if (const auto joint = jointNumber(name)) {
      home_[*joint] = radians(degrees);
    }
  }
  joinHipYawPitch(home_);
  home_ = limits_.clamped(home_);
  state_.edit().home = home_;
}

void PosePlayer::cycle() {
  state_.edit();
  if (measured_->isNew) {
    now_ = measured_->state.time;
    watch(measured_->state);
    if (const PoseRequest* request = request_->take()) {
      look(*request);
    }
    advance();
  }
  ending_.atRest = state_->phase == Phase::off || state_->phase == Phase::fallen || state_->atHome;
  forBrain_.edit().write(*state_);
}

void PosePlayer::watch(const RobotState& state) {
  const bool pressed = state.touch.chestButton;
  const bool newlyPressed = pressed && !wasPressed_;
  wasPressed_ = pressed;
  const Phase phase = state_->phase;
  if (newlyPressed && (phase == Phase::off || phase == Phase::fallen || state_->atHome)) {
    ++state_.edit().presses;
  }
  if (phase == Phase::off || phase == Phase::fallen) {
    return;
  }
  const double tilt = degrees(state.torsoAngles.cwiseAbs().maxCoeff());
  const auto hot = std::max_element(state.temperature.begin(), state.temperature.end());
  if (tilt > *largestTilt_) {
    stop(Phase::fallen, fmt::format("The torso is tilted by {:.0f} degrees, so the motors are weak. Stand the robot up "
                                    "and start again.",
                                    tilt));
  } else if (isTouched(state.touch) && motion_) {
    stop(Phase::holding, "The robot was touched and stopped. Press its chest button to have it go back to its stand.");
  } else if (newlyPressed && !goingHome_ && !state_->atHome) {
    goHome("The chest button was pressed: the robot goes back to its stand.");
  } else if (ending_.asked && !goingHome_ && !state_->atHome) {
    goHome("The program is being ended: the robot goes back to its stand.");
  } else if (*hot > *hottest_ && !goingHome_ && !state_->atHome) {
    goHome(fmt::format("{} is {:.0f} degrees Celsius hot: the robot goes back to its stand. Let it cool down.",
                       jointNames[static_cast<std::size_t>(hot - state.temperature.begin())], *hot));
  }
}

void PosePlayer::look(const PoseRequest& request) {
  PlayerState& state = state_.edit();
  state.request = request.number;
  state.held = request.held;
  state.done = false;
  switch (request.kind) {
  case PoseRequest::Kind::go:
    return go(request);
  case PoseRequest::Kind::home:
    return goHome("");
  case PoseRequest::Kind::rest:
    stop(Phase::off, "");
    state.done = true;
  }
}

std::string PosePlayer::unreachable(const PoseRequest& request) const {
  for (const CompensatedAngles& point : request.points) {
    const CompensatedAngles reachable = limits_.clamped(point);
    for (std::size_t joint = 0; joint < jointCount; ++joint) {
      if (!(std::abs(point[joint] - reachable[joint]) < 1e-6)) { // also for what is no number
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
  PlayerState& state = state_.edit();
  if (state.phase == Phase::moving || state.phase == Phase::holding) {
    return true;
  }
  if (!isNear(*angles_, home_)) {
    state.reason = fmt::format("{} was refused: the robot is not at its stand. Put it there (each joint within {:.0f} "
                               "degrees) and start again.",
                               who, *startDistance_);
    return false;
  }
  desired_.edit().angles = *angles_;
  trail_ = {home_};
  return true;
}

void PosePlayer::go(const PoseRequest& request) {
  state_.edit().reason = unreachable(request);
  if (!state_->reason.empty() || !isReady(request.name)) {
    return;
  }
  leaveMotion();
  extendTrail(desired_->angles);
  start(request.points);
}

void PosePlayer::goHome(const std::string& reason) {
  state_.edit().reason = reason;
  if (!isReady("Going to the stand")) {
    return;
  }
  leaveMotion();
  start({trail_.rbegin(), trail_.rend()});
  goingHome_ = true;
}

void PosePlayer::start(std::vector<CompensatedAngles> points) {
  points_ = std::move(points);
  motion_.emplace(desired_->angles, points_, limits_, *speed_);
  motionStart_ = now_;
  state_.edit().phase = Phase::moving;
  state_.edit().atHome = false;
  desired_.edit().stiffness = *stiffness_;
}

void PosePlayer::leaveMotion() {
  if (!motion_) {
    return;
  }
  const auto passed = points_.begin() + static_cast<std::ptrdiff_t>(motion_->passed(seconds(now_ - motionStart_)));
  if (goingHome_) {
    trail_.assign(std::make_reverse_iterator(points_.end()), std::make_reverse_iterator(passed));
  } else {
    std::for_each(points_.begin(), passed, [this](const CompensatedAngles& point) { extendTrail(point); });
  }
  motion_.reset();
  goingHome_ = false;
}

void PosePlayer::extendTrail(const CompensatedAngles& point) {
  const auto known = std::find(trail_.begin(), trail_.end(), point);
  trail_.erase(known == trail_.end() ? known : known + 1, trail_.end());
  if (known == trail_.end()) {
    trail_.push_back(point);
  }
}

void PosePlayer::stop(Phase phase, const std::string& reason) {
  leaveMotion();
  PlayerState& state = state_.edit();
  state = {.phase = phase,
           .request = state.request,
           .held = state.held,
           .home = home_,
           .reason = reason,
           .presses = state.presses};
  desired_.edit().stiffness = phase == Phase::off ? 0 : phase == Phase::fallen ? *fallenStiffness_ : *stiffness_;
}

void PosePlayer::advance() {
  PlayerState& state = state_.edit();
  DesiredPose& desired = desired_.edit();
  if (state.phase == Phase::off || state.phase == Phase::fallen) {
    desired.angles = *angles_; // nothing pulls when the motors come on
    return;
  }
  if (!motion_) {
    return;
  }
  const double time = seconds(now_ - motionStart_);
  desired.angles = motion_->at(time);
  state.progress = std::min(1.0, time / motion_->duration());
  state.secondsLeft = std::max(0.0, motion_->duration() - time);
  if (time >= motion_->duration()) {
    state.phase = Phase::holding;
    state.done = true;
    state.doneAt = now_;
    state.atHome = goingHome_;
    leaveMotion();
    trail_ = state.atHome ? std::vector{home_} : trail_;
  }
}

void to_json(nlohmann::json& out, const DesiredPose& desired) {
  out = {{"angles", desired.angles.values}, {"stiffness", desired.stiffness}};
}

} // namespace naocal
