#pragma once

#include "hardware/RobotCommand.hpp"
#include "hardware/exchange/PoseRequest.hpp"

namespace naocal {

/// What the eyes tell people beside the robot: dark while its motors are off, white while they hold it, yellow while a
/// person shall hold it, red after a fall.
Leds lights(const PlayerState& player);

} // namespace naocal
