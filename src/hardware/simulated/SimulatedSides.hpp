#pragma once

#include "hardware/RobotInterface.hpp"
#include "hardware/simulated/SimulatedShared.hpp"

#include <memory>

namespace naocal {

/// The motion loop's side of a simulated world: a cycle per state.
std::unique_ptr<RobotInterface> simulatedRobot(std::shared_ptr<SimulatedShared> shared);

/// The camera loop's side.
std::unique_ptr<CameraInterface> simulatedCameras(std::shared_ptr<SimulatedShared> shared);

} // namespace naocal
