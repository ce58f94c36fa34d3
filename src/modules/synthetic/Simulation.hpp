#pragma once

#include "synthetic/SimulationPlan.hpp"
#include "synthetic/Truth.hpp"
#include "synthetic/Walk.hpp"

#include <cstdint>

namespace naocal {

/// A capture set and what is true about it.
struct Simulation {
  CaptureSet set;
  Truth truth;
  std::vector<Exposure> exposures; // one per capture
};

/// What the body and head ids of simulated robots begin with; their seed follows.
constexpr const char* syntheticId = "synthetic-";

/// A robot of this drawing, with errors drawn at random, walks through the plan. The same seed gives the same.
Simulation simulate(const Robot& drawing, const SimulationPlan& plan, std::uint64_t seed);

} // namespace naocal
