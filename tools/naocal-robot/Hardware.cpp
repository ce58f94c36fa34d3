#include "Hardware.hpp"

#include "data/CaptureSetFile.hpp"
#include "framework/configuration/ConfigurationLayers.hpp"
#include "hardware/nao/LolaRobot.hpp"
#include "hardware/nao/SharedMemoryRobot.hpp"
#include "hardware/simulated/SimulatedWorld.hpp"
#include "hardware/v4l2/VideoCameras.hpp"
#include "poses/PoseFile.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

SimulatedPlan simulatedPlan(std::uint64_t seed, const std::filesystem::path& configuration) {
  SimulatedPlan plan;
  plan.seed = seed;
  const std::filesystem::path file = configuration / "poses" / (plan.model + ".json");
  for (const auto& [id, placement] : readPoseFile(file, loadRobot(configuration, plan.model)).boards) {
    for (Board& board : plan.boards) {
      if (board.id == id) {
        board.placement = placement;
        board.placement->y += halfFootDistance; // pose file: relative to the left sole
      }
    }
  }
  return plan;
}

Hardware simulatedHardware(const SimulatedPlan& plan, const std::filesystem::path& configuration) {
  Hardware hardware{loadRobot(configuration, plan.model), nullptr, nullptr, "simulated"};
  SimulatedWorld world{hardware.drawing, plan};
  hardware.robot = world.robot();
  hardware.cameras = world.cameras();
  return hardware;
}

Hardware replayedHardware(const std::filesystem::path& round, const std::filesystem::path& configuration) {
  const CaptureSet recorded = readCaptureSet(round).set;
  const RobotNames names = findRobotNames(configuration, recorded.headId, recorded.bodyId);
  const Overlay collector{layerFiles(configuration, "CaptureCollector.json", RobotPart::head, names)};
  ReplayOptions options;
  if (const auto latency = collector.merged->find("latency"); latency != collector.merged->end()) {
    if (!latency->is_number()) {
      throw ConfigurationError{fmt::format("{}: latency: expected a number of seconds", round.string())};
    }
    options.latency = fromSeconds(latency->get<double>());
  }
  const auto world = std::make_shared<ReplayWorld>(round, options);
  return {loadRobot(configuration, world->set().model), world->robot(), world->cameras(), "", world};
}

Hardware naoHardware(const std::string& model, const std::filesystem::path& configuration) {
  Hardware hardware{loadRobot(configuration, model), nullptr, nullptr, ""};
  if (model == "V5") {
    hardware.robot = std::make_unique<SharedMemoryRobot>();
  } else {
    hardware.robot = std::make_unique<LolaRobot>();
  }
  hardware.cameras = std::make_unique<VideoCameras>(videoOptionsForModel(model));
  return hardware;
}

} // namespace naocal
