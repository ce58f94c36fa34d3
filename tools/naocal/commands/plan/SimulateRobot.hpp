#pragma once

#include "commands/plan/OtherRobot.hpp"
#include "scenes/SceneSimulation.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace naocal {

/// What `naocal simulate` is asked for, of a robot that is no NAO.
struct RobotSimulation {
  std::string robot, scene, support, poses; // as given; `scene`: a file, or empty
  bool hasPixelNoise = false;               // whether `pixelNoise` replaces the scene's
  double pixelNoise = 0;                    // [px]
  double poseNoise = 0;                     // added to the scene's if it has none [rad]
  double approachNoise = 0;                 // likewise, at every approach [rad]
  ScenePlan plan;                           // but for the poses
};

/// The number of poses that --poses asks for; absent where it names a file. Throws InputError for a number that is not
/// a whole one, 1 to 1000.
std::optional<std::size_t> parsePoseCount(const std::string& poses);

/// Options of `naocal simulate` that only a NAO has.
std::span<const NaoOption> naoOptionsOfSimulate();

/// Throws InputError for a scene, a number of poses, a pose file or a flaw that this robot cannot have.
SceneSimulation simulateRobot(RobotSimulation asked);

/// Copies the URDF into the set's folder and lets the set name the copy; nothing for a shipped model.
void copyUrdf(const std::string& folder, CaptureSet& set);

} // namespace naocal
