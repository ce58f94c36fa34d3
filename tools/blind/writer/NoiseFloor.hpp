#pragma once

#include "writer/SetFile.hpp"

namespace blind {

/// How far corners lie from their predictions by someone who knows the robot with all its flaws, finds out where boards
/// and feet stand, but reads the angles with the encoders' errors and does not know where friction held the links: rms
/// of distances [px].
double noiseFloor(const Robot& robot, const Session& session, const NoiseRegime& noise, const SeenCorners& seen);

} // namespace blind
