#include "motion/CommandSender.hpp"

#include "math/Angles.hpp"
#include "motion/Lights.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>

namespace naocal {

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
  command.angles = sentToMotors(desired_->angles, added_, limits_);
  command.stiffness.fill(desired_->stiffness);
  command.leds = lights(*player_);
  robot_.send(command);
  sent_ = command.angles;
}

} // namespace naocal
