#include "motion/CommandSender.hpp"

#include "hardware/RobotInterface.hpp"
#include "hardware/messages/PoseRequest.hpp"
#include "math/Angles.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>

namespace naocal {
namespace {

/// Eye colour of a player state: dark: motors off; white: motors on; yellow: a person must hold the robot; red: after a
/// fall.
Leds ledsFor(const PlayerState& player) {
  using Phase = PlayerState::Phase;
  constexpr Rgb dark{}, white{0.5f, 0.5f, 0.5f}, red{1, 0, 0};
  const Rgb eyes = player.phase == Phase::fallen ? red
                   : player.phase == Phase::off  ? dark
                   : player.held                 ? holdMeColour
                                                 : white;
  Leds leds;
  leds.leftEye.fill(eyes);
  leds.rightEye.fill(eyes);
  return leds;
}

} // namespace

void CommandSender::cycle() {
  if (!measured_->isNew) {
    return;
  }
  const PlayerState::Phase phase = player_->phase;
  const bool isOnOneFoot =
      player_->needsHands && (phase == PlayerState::Phase::moving || phase == PlayerState::Phase::holding);
  const double most = std::exchange(isFirst_, false) ? 2 * std::numbers::pi
                      : isOnOneFoot                  ? 0
                                                     : radians(*offsetSpeed_) * measured_->step();
  for (std::size_t joint = 0; joint < jointCount; ++joint) {
    added_.values[joint] += std::clamp(offsets_->values[joint] - added_.values[joint], -most, most);
  }
  RobotCommand command;
  command.angles = toMotorAngles(desired_->angles, added_, limits_);
  command.stiffness.fill(desired_->stiffness);
  command.leds = ledsFor(*player_);
  robot_.send(command);
  sent_ = command.angles;
}

} // namespace naocal
