#include "Hardware.hpp"

#include "hardware/simulated/SimulatedWorld.hpp"

namespace naocal {

Hardware simulatedHardware(std::uint64_t seed) {
  SimulatedPlan plan;
  plan.seed = seed;
  Hardware hardware{loadRobot(configurationDirectory(), plan.model), nullptr, nullptr, "simulated"};
  SimulatedWorld world{hardware.drawing, plan};
  hardware.robot = world.robot();
  hardware.cameras = world.cameras();
  return hardware;
}

} // namespace naocal
