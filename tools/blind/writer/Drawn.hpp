#pragma once

#include "writer/Chance.hpp"
#include "writer/Design.hpp"
#include "writer/Staging.hpp"

namespace blind {

/// How the session of an item is held: what the item leaves open is drawn.
SessionPlan drawnPlan(const Item& item, Chance& chance);

/// A robot without flaws but with offsets within 6.5 degrees and camera mounts within 2 degrees.
Robot drawnRobot(const Drawing& drawing, std::size_t boards, Chance& chance);

/// The same robot with its offsets and mounts, all else sound.
Robot withoutFlaws(Robot robot);

NoiseRegime noiseRegime(const std::string& name);

} // namespace blind
