#pragma once

#include "DrivenProcess.hpp"

#include "hardware/simulated/SimulatedWorld.hpp"

#include "Hardware.hpp"

namespace naocal {

/// The process on a simulated robot, faster than real time.
struct SimulatedProcess : DrivenProcess {
  explicit SimulatedProcess(const SimulatedPlan& plan)
      : world{drawing, plan}, robot{world.robot()}, cameras{world.cameras()} {
    begin(*robot, *cameras, drawing, [this] { return world.truth().time; });
  }
  ~SimulatedProcess() { process.reset(); }

  static SimulatedPlan plan(std::uint64_t seed, double offsetRange, double playRange = 0) {
    SimulatedPlan plan = simulatedPlan(seed);
    plan.offsetRange = offsetRange;
    plan.playRange = playRange;
    plan.pace = Pace::quick;
    return plan;
  }

  Robot drawing = loadRobot(configurationDirectory(), "V6");
  SimulatedWorld world;
  std::unique_ptr<RobotInterface> robot;
  std::unique_ptr<CameraInterface> cameras;
};

} // namespace naocal
