#pragma once

#include "simulation/Renderer.hpp"
#include "simulation/SimulationPlan.hpp"

#include <string>

namespace CLI {
class App;
}

namespace naocal {

/// What `naocal simulate` is told. Angles in degrees and shifts in millimetres, as people give them.
struct SimulateOptions {
  std::string output, robot = "V6", support = "left", repeatKind = "rest", size = "640x480", json;
  std::string poses = "24"; // how many, or a pose file
  std::uint64_t seed = 1;
  double offsetDegrees = 6.5, mountDegrees = 2, mountMillimetres = 0, poseDegrees = 0, approachDegrees = 0;
  bool displacedBoard = false, samePlace = false, force = false;
  SimulationPlan plan;
  Appearance appearance;
};

void addOptions(CLI::App& simulator, SimulateOptions& options);

/// The plan that the options describe, with its poses. Throws InputError for what is no size, and no number of poses
/// nor a pose file.
SimulationPlan planOf(const SimulateOptions& options, const Robot& robot);

} // namespace naocal
