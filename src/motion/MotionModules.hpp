#pragma once

#include "framework/core/Thread.hpp"
#include "hardware/RobotInterface.hpp"
#include "motion/PosePlayer.hpp"
#include "robot/Robot.hpp"

namespace naocal {

/// Adds the motion thread's modules. `robot`, `drawing` and `ending` must outlive the thread.
void addMotionModules(Thread& motion, RobotInterface& robot, const Robot& drawing, ShutdownRequest& ending);

} // namespace naocal
