#pragma once

#include "scenes/RobotScene.hpp"

#include <CLI/App.hpp>
#include <cstdint>
#include <span>
#include <string>

namespace naocal {

/// An option that only NAOs have, and why others do not.
struct NaoOption {
  const char *name, *why;
};

/// Whether the robot is none of those that standing poses are planned for: a URDF, or a model with other legs.
bool isOtherRobot(const std::string& robot);

/// Throws InputError for given options that only a NAO has, and for --support of a robot with a URDF.
void refuseNaoOptions(const CLI::App& command, const std::string& robot, std::span<const NaoOption> options);

/// The scene of a robot that is no NAO: of a file, or, if that is empty, what suits the robot. `support`: as given.
/// Throws InputError for a scene that this robot cannot have.
RobotScene loadScene(const std::string& robot, const std::string& file, const std::string& support, std::uint64_t seed);

} // namespace naocal
