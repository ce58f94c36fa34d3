#pragma once

#include "poses/CapturePlan.hpp"
#include "scenes/RobotScene.hpp"

#include <cstdint>

namespace naocal {

struct SceneCandidatesOptions {
  std::size_t count = 400;     // candidates that are measured; drawing ends with them
  std::size_t draws = 100'000; // at most
  std::uint64_t seed = 1;
};

/// What the captures of a pose show. `set`: what they are of; `angles`: of the pose [rad].
PlannedPose describeSight(const CaptureSet& set, const std::vector<Capture>& captures, const Eigen::VectorXd& angles);

/// Whether a capture holds a corner or a reading.
bool showsAnything(const Capture& capture);

/// Draws candidate poses of a robot without offsets among things that stand exactly where its scene says (ScenePoses),
/// and keeps those in which a camera sees eight corners of a board, or, in a scene without cameras, a tracker sees a
/// marker or frame. Approaches are random. Reproducible by seed.
///
/// Throws InputError for a scene that nothing measures, and if no pose is measured.
CandidateCaptures drawCandidates(const RobotScene& scene, const SceneCandidatesOptions& options = {});

} // namespace naocal
