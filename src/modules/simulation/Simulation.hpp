#pragma once

#include "simulation/SimulationPlan.hpp"
#include "simulation/SyntheticRobot.hpp"
#include "simulation/Truth.hpp"

#include <cstdint>

namespace naocal {

/// True state at one capture.
struct Exposure {
  Eigen::VectorXd joints; // true joint angles [rad]
  Eigen::Isometry3d worldFromCamera = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Isometry3d> worldFromBoard; // in the order of the plan's boards
};

/// Recorded captures of all poses, without corners.
struct CaptureSequence {
  std::vector<Stance> stances; // with their true placements
  std::vector<Capture> captures;
  std::vector<Exposure> exposures; // one per capture
};

/// Moves through the plan's poses and records all cameras, 30 ms apart, `samples` times: in place (rest), after leaving
/// the pose and returning (reapproach), or in that many rounds of all poses with new stances (restand).
CaptureSequence recordCaptures(const SyntheticRobot& robot, const SimulationPlan& plan,
                               const std::vector<Placement>& boards, std::uint64_t seed);

/// A simulated capture set and its ground truth.
struct Simulation {
  CaptureSet set;
  Truth truth;
  std::vector<Exposure> exposures; // one per capture
};

/// Prefix of the body and head ids of simulated robots; the seed follows.
constexpr const char* syntheticIdPrefix = "synthetic-";

/// Simulates a robot of this drawing with random errors in all poses of the plan. Reproducible by seed.
Simulation simulate(const Robot& drawing, const SimulationPlan& plan, std::uint64_t seed);

} // namespace naocal
