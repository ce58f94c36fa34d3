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

/// A robot behind its two interfaces.
struct Hardware {
  Robot drawing;
  std::unique_ptr<RobotInterface> robot;
  std::unique_ptr<CameraInterface> cameras;
  std::string location; // of its configuration, where sdk.json's does not suit it; empty: as sdk.json says
  std::shared_ptr<const ReplayWorld> replay = nullptr;
};

/// A simulated robot that stands before four boards, which lie where its model's poses want them, with offsets and
/// mounts drawn by the seed. `configuration`: the folder with drawings and poses, here and below.
SimulatedPlan simulatedPlan(std::uint64_t seed, const std::filesystem::path& configuration = configurationDirectory());
Hardware simulatedHardware(const SimulatedPlan& plan, const std::filesystem::path& configuration);

/// A recorded round of a calibration, with the latency between picture and joints that the configuration says. Throws
/// InputError or ConfigurationError.
Hardware replayedHardware(const std::filesystem::path& round, const std::filesystem::path& configuration);

/// The NAO that this process runs on: V6 through its hardware service, V5 through the module in NAOqi; both cameras
/// through V4L2. Neither needs to answer yet. Throws std::invalid_argument for other models.
Hardware naoHardware(const std::string& model, const std::filesystem::path& configuration);

} // namespace naocal
