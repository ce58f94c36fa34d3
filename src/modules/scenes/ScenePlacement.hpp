#pragma once

#include "scenes/RobotScene.hpp"
#include "scenes/SceneSimulation.hpp"

namespace naocal {

/// Draws where things truly stand: exactly where the scene places them, else about there (within 3 cm and 0.1 rad,
/// places and markers within 1 cm, times the plan's spread). The scene's set with everything placed, in the simulator's
/// world.
CaptureSet placeScene(const RobotScene& scene, const ScenePlan& plan);

} // namespace naocal
