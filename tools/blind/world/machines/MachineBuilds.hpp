#pragma once

#include "world/RandomStream.hpp"
#include "world/machines/Machine.hpp"

namespace blind {

enum class MachineBuild {
  elbow,   // six axes, three of them crossing in the wrist
  offset,  // six axes, three of them parallel, none crossing in one point
  slender, // seven axes
  railed,  // elbow on a linear rail
  legged   // a torso on one leg of six axes, with a head of two
};

/// A machine of that build with numbers of its own: lengths, masses, limits and frames, which lie anyhow on their
/// axes (parallel to the base, turned by right angles, or anyhow).
Machine drawMachine(MachineBuild build, RandomStream& chance);

} // namespace blind
