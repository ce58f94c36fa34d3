#pragma once

#include "robot/Robot.hpp"
#include "simulation/Simulation.hpp"
#include "simulation/StandingPoses.hpp"

namespace naocal {

/// Captures of a simulated NAO on its left foot: three poses, one sample each.
inline CaptureSet smallSet(const Robot& robot) {
  SimulationPlan plan;
  plan.poses = planStandingPoses(robot, plan, SupportFoot::left, 3, 1);
  plan.samples = 1;
  return simulate(robot, plan, 1).set;
}

} // namespace naocal
