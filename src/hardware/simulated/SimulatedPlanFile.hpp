#pragma once

#include "hardware/simulated/SimulatedPlan.hpp"

#include <filesystem>

namespace naocal {

/// Reads what to simulate. All keys may be missing; what they would say is as in `plan`:
///
///     {"model": "V6", "seed": 1, "pace": "real",                                  or "quick"
///      "offsetRangeDegrees": 5, "mountRangeDegrees": 2, "playRangeDegrees": 0,    hidden errors, drawn by the seed
///      "droopDegreesPerNewtonMetre": 0.057,
///      "exposureSeconds": 0.01, "readOutSeconds": 0.024, "jitterSeconds": 0, "lostShare": 0, "pictureNoise": 3,
///      "boards": [...]}                                                           as in a capture set, with placements
///
/// Throws InputError: file, place, what was expected, what was found.
SimulatedPlan readSimulatedPlan(const std::filesystem::path& file, SimulatedPlan plan = {});

} // namespace naocal
