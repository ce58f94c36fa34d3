#pragma once

#include "hardware/RobotCommand.hpp"
#include "hardware/RobotState.hpp"
#include "hardware/nao/naoqi/SharedBlock.h"

namespace naocal {

/// A state as this program has it, and a command as the shared block has it.
RobotState fromShared(const shared::State& state);
shared::Command toShared(const RobotCommand& command);

} // namespace naocal
