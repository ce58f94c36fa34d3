#pragma once

#include "simulation/Simulation.hpp"
#include "simulation/StandingPoses.hpp"

#include <cstdint>
#include <map>

namespace naocal {

/// Captures of a simulated robot, three approaches per pose; poses are planned once per count.
inline CaptureSet simulatedSet(std::size_t poses, std::uint64_t seed, double stiction = 0) {
  static const Robot robot = loadRobot(configurationDirectory(), "V6");
  static std::map<std::size_t, std::vector<CommandedPose>> known;
  SimulationPlan plan;
  auto& chosen = known[poses];
  if (chosen.empty()) {
    chosen = planStandingPoses(robot, plan, SupportFoot::left, poses, 1);
  }
  plan.poses = chosen;
  plan.repeatKind = RepeatKind::reapproach;
  plan.mechanics.poseScatter = stiction;
  return simulate(robot, plan, seed).set;
}

} // namespace naocal
