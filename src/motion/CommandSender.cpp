#include "motion/CommandSender.hpp"

#include <nlohmann/json.hpp>

namespace naocal {

void CommandSender::cycle() {
  if (!measured_->isNew) {
    return;
  }
  RobotCommand command;
  command.angles = sentToMotors(desired_->angles, *offsets_, limits_);
  command.stiffness.fill(desired_->stiffness);
  robot_.send(command);
  sent_ = command.angles;
}

} // namespace naocal
