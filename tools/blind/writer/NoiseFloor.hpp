#pragma once

#include "writer/SetFile.hpp"

namespace blind {

/// How far corners lie from their predictions by someone who knows the robot with all its flaws, finds out by plain
/// least squares where boards and feet stand (as a comparison does), but reads the angles with the encoders' errors and
/// does not know where friction held the links: rms of distances [px].
double noiseFloor(const Robot& robot, const Session& session, const SeenCorners& seen);

} // namespace blind
