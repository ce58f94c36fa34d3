#include "motion/CommandSender.hpp"

#include "geometry/Angles.hpp"
#include "motion/Lights.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

namespace naocal {

void CommandSender::cycle() {
  if (!measured_->isNew) {
    return;
  }
  const TimePoint now = measured_->state.time;
  constexpr double longestStep = 0.03; // [s]; silence is no reason to jump
  const double most = last_ ? radians(*offsetSpeed_) * std::min(seconds(now - *last_), longestStep)
                            : 2 * std::numbers::pi; // first: at once
  last_ = now;
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
