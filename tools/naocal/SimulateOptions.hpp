#pragma once

#include "synthetic/Rendering.hpp"
#include "synthetic/SimulationPlan.hpp"

#include <string>

namespace CLI {
class App;
}

namespace naocal {

/// What `naocal simulate` is told. Angles in degrees and shifts in millimetres, as people give them.
struct SimulateOptions {
  std::string output, robot = "V6", support = "left", repeatKind = "rest", size = "640x480", json;
  std::size_t poses = 24;
  std::uint64_t seed = 1;
  double offsetDegrees = 6.5, mountDegrees = 2, mountMillimetres = 0, poseDegrees = 0, approachDegrees = 0;
  bool displacedBoard = false;
  SimulationPlan plan;
  Appearance appearance;
};

void addOptions(CLI::App& simulator, SimulateOptions& options);

/// The foot that was asked for.
SupportFoot supportFoot(const SimulateOptions& options);

/// The plan that the options describe, without poses. Throws InputError for a size that is none.
SimulationPlan planOf(const SimulateOptions& options);

} // namespace naocal
