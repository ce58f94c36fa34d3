#include "math/Angles.hpp"
#include "motion/PosePlayer.hpp"

#include <algorithm>
#include <fmt/format.h>

/// What makes the player leave what it does: buttons, touch, heat, falls, silence.
namespace naocal {
namespace {

using Phase = PlayerState::Phase;

constexpr double longestSilence = 0.1; // [s]

bool isTouched(const Touch& touch) {
  return touch.headFront || touch.headMiddle || touch.headRear || touch.leftFootLeft || touch.leftFootRight ||
         touch.rightFootLeft || touch.rightFootRight || touch.leftHandBack || touch.leftHandLeft ||
         touch.leftHandRight || touch.rightHandBack || touch.rightHandLeft || touch.rightHandRight;
}

} // namespace

void PosePlayer::afterSilence(double length) {
  const bool plays = state_->phase == Phase::moving || state_->phase == Phase::holding;
  if (plays && length > longestSilence && !isNear(*angles_, desired_->angles)) {
    stop(Phase::fallen, fmt::format("Nothing was heard of the robot for {:.1f} s, and its joints were moved meanwhile, "
                                    "so the motors are weak. Stand the robot up and start again.",
                                    length));
  }
}

void PosePlayer::chestPressed() {
  const Phase phase = state_->phase;
  const bool isOwn = (phase == Phase::moving || phase == Phase::holding) && !state_->atHome && !waits_;
  if (!isOwn) {
    ++state_.edit().presses;
  } else if (handsUntil_) {
    startHome();
  } else if (!goingHome_) {
    goHome("The chest button was pressed: the robot goes back to its stand.");
  }
}

void PosePlayer::watch(const RobotState& state) {
  const bool newlyPressed = state.touch.chestButton && !wasPressed_;
  wasPressed_ = state.touch.chestButton;
  if (newlyPressed) {
    chestPressed();
  }
  if (state_->phase == Phase::off || state_->phase == Phase::fallen) {
    return;
  }
  const double tilt = degrees(std::max(std::abs(state.torsoAngles.x()), std::abs(state.torsoAngles.y())));
  const auto hot = std::max_element(state.temperature.begin(), state.temperature.end());
  const bool isOut = !goingHome_ && !handsUntil_ && !state_->atHome;
  if (tilt > *largestTilt_) {
    stop(Phase::fallen, fmt::format("The torso is tilted by {:.0f} degrees, so the motors are weak. Stand the robot up "
                                    "and start again.",
                                    tilt));
  } else if (isTouched(state.touch) && motion_) {
    stop(Phase::holding, "The robot was touched and stopped. Press its chest button to have it go back to its stand.");
  } else if (ending_.asked && isOut) {
    goHome("The program is being ended: the robot goes back to its stand.");
  } else if (*hot > *hottest_ && isOut) {
    goHome(fmt::format("{} is {:.0f} degrees Celsius hot: the robot goes back to its stand. Let it cool down.",
                       jointNames[static_cast<std::size_t>(hot - state.temperature.begin())], *hot));
  }
}

} // namespace naocal
