#pragma once

#include "framework/core/Thread.hpp"
#include "hardware/RobotInterface.hpp"
#include "motion/PosePlayer.hpp"
#include "robot/Robot.hpp"

namespace naocal {

/// The motion thread's modules, for a robot and its drawing, which must outlive the thread, and so must `ending`.
void addMotionModules(Thread& motion, RobotInterface& robot, const Robot& drawing, ShutdownRequest& ending);

} // namespace naocal
