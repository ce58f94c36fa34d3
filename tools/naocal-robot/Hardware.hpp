#pragma once

#include "hardware/CameraInterface.hpp"
#include "hardware/RobotInterface.hpp"
#include "hardware/replay/ReplayWorld.hpp"
#include "hardware/simulated/SimulatedPlan.hpp"
#include "robot/Robot.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace naocal {

/// A robot: its drawing and its two interfaces.
struct Hardware {
  Robot drawing;
  std::unique_ptr<RobotInterface> robot;
  std::unique_ptr<CameraInterface> cameras;
  std::string location; // of its configuration, if sdk.json's does not fit; empty: as in sdk.json
  std::shared_ptr<const ReplayWorld> replay = nullptr;
};

/// A simulated robot in front of four boards, placed as its model's pose file assumes; offsets and mounts are drawn by
/// the seed. `configuration`: the folder with drawings and poses, here and below.
SimulatedPlan simulatedPlan(std::uint64_t seed, const std::filesystem::path& configuration = configurationDirectory());
Hardware simulatedHardware(const SimulatedPlan& plan, const std::filesystem::path& configuration);

/// A recorded calibration round, with the latency between image and joints from the configuration. Throws InputError or
/// ConfigurationError.
Hardware replayedHardware(const std::filesystem::path& round, const std::filesystem::path& configuration);

/// The NAO that runs this process: V6 through its hardware service, V5 through the NAOqi module; both cameras through
/// V4L2. Neither needs to respond yet. Throws std::invalid_argument for other models.
Hardware naoHardware(const std::string& model, const std::filesystem::path& configuration);

} // namespace naocal
