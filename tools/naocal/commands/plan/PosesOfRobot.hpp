#pragma once

#include "commands/plan/OtherRobot.hpp"
#include "poses/CapturePlan.hpp"
#include "scenes/SceneCandidates.hpp"

#include <span>
#include <string>

namespace naocal {

/// What `naocal poses` is asked for, of a robot that is no NAO.
struct PosesOfRobot {
  std::string robot, scene, support, output; // as given; `scene`: a file, or empty
  CapturePlanOptions plan;
  SceneCandidatesOptions candidates;
};

/// Options of `naocal poses` that only a NAO has.
std::span<const NaoOption> naoOptionsOfPoses();

/// Plans, prints and writes the poses. Throws InputError for a scene, effects or a number of poses that this robot
/// cannot have.
void planPosesOfRobot(const PosesOfRobot& asked);

} // namespace naocal
