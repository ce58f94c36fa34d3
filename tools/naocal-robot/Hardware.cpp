#include "Hardware.hpp"

#include "hardware/nao/LolaRobot.hpp"
#include "hardware/nao/SharedMemoryRobot.hpp"
#include "hardware/nao/VideoCameras.hpp"
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

Hardware naoHardware(const std::string& model) {
  Hardware hardware{loadRobot(configurationDirectory(), model), nullptr, nullptr, ""};
  if (model == "V5") {
    hardware.robot = std::make_unique<SharedMemoryRobot>();
  } else {
    hardware.robot = std::make_unique<LolaRobot>();
  }
  hardware.cameras = std::make_unique<VideoCameras>(videoOptions(model));
  return hardware;
}

} // namespace naocal
