#pragma once

#include "scenes/SceneSimulation.hpp"

#include <CLI/App.hpp>
#include <string>

namespace naocal {

/// What `naocal simulate` is asked for, of a robot that is no NAO.
struct RobotSimulation {
  std::string robot, scene, support, poses; // as given; `scene`: a file, or empty
  bool hasPixelNoise = false;               // whether `pixelNoise` replaces the scene's
  double pixelNoise = 0;                    // [px]
  double poseNoise = 0;                     // added to the scene's if it has none [rad]
  ScenePlan plan;                           // but for the number of poses
};

/// The number of poses that --poses asks for. Throws InputError for anything but a whole number, 1 to 1000; `remark`
/// completes what was expected: "or a pose file".
std::size_t parsePoseCount(const std::string& poses, const std::string& remark);

/// Whether the robot is none of those that `simulate` plans standing poses for: a URDF, or a model with other legs.
bool isOtherRobot(const std::string& robot);

/// Throws InputError for an option that only a NAO's simulation has.
void refuseNaoOptions(const CLI::App& simulator, const std::string& robot);

/// Throws InputError for a scene, a number of poses or a flaw that this robot cannot have.
SceneSimulation simulateRobot(RobotSimulation asked);

/// Copies the URDF into the set's folder and lets the set name the copy; nothing for a shipped model.
void copyUrdf(const std::string& folder, CaptureSet& set);

} // namespace naocal
