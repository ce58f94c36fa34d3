#pragma once

#include "robot/Robot.hpp"

namespace naocal {

inline const Robot& v6() {
  static const Robot robot = loadRobot(configurationDirectory(), "V6");
  return robot;
}

} // namespace naocal
