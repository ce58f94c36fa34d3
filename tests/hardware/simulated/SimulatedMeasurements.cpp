#include "RobotV6.hpp"
#include "hardware/simulated/SimulatedWorld.hpp"
#include "simulation/StandingPoses.hpp"

#include <catch2/catch.hpp>
#include <thread>

using namespace naocal;
using namespace std::chrono_literals;

// Measurement; proves nothing.
TEST_CASE("how a simulated robot fares and what it costs", "[.measure]") {
  const Robot& drawing = v6();
  SimulationPlan poses;
  const auto commanded = planStandingPoses(drawing, poses, SupportFoot::left, 8, 1);
  int fallen = 0, cycles = 0, onBoth = 0;
  double seconds = 0;
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    for (const CommandedPose& pose : commanded) {
      SimulatedPlan plan;
      plan.seed = seed;
      plan.pace = Pace::quick;
      plan.playRange = radians(0.5);
      RobotCommand command;
      for (std::size_t j = 0; j < drawing.joints.size(); ++j) {
        plan.start[*jointIndex(drawing.joints[j].name)] = pose.angles[Eigen::Index(j)];
      }
      command.angles = plan.start;
      command.stiffness.fill(0.8);
      SimulatedWorld world{drawing, plan};
      const auto robot = world.robot();
      const auto began = std::chrono::steady_clock::now();
      for (int i = 0; i < 100; ++i, ++cycles) {
        robot->waitForState(1s);
        robot->send(command);
      }
      seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
      fallen += world.truth().fallen;
      onBoth += !world.truth().fallen && world.truth().supportFoot != SupportFoot::left;
    }
  }
  WARN(fallen << " of 200 robots with offsets of 5 degrees fell in their poses, " << onBoth
              << " leant on both feet; a cycle takes " << 1e6 * seconds / cycles << " us");
  SimulatedPlan plan;
  plan.pace = Pace::quick;
  SimulatedWorld world{drawing, plan};
  const auto robot = world.robot();
  const auto cameras = world.cameras();
  std::thread motion{[&] {
    for (int i = 0; i < 250; ++i) {
      robot->waitForState(1s);
    }
  }};
  double sum = 0;
  int count = 0;
  while (const auto frame = cameras->waitForFrame(300ms)) {
    const auto began = std::chrono::steady_clock::now();
    frame->picture->bytes();
    sum += std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    ++count;
  }
  motion.join();
  WARN(count << " pictures were rendered in " << 1e3 * sum / count << " ms each");
}
