#pragma once

#include "simulation/SimulationPlan.hpp"
#include "simulation/SyntheticRobot.hpp"
#include "simulation/Truth.hpp"

#include <cstdint>

namespace naocal {

/// What was before a camera when a capture was taken.
struct Exposure {
  Eigen::VectorXd joints; // as they really were [rad]
  Eigen::Isometry3d worldFromCamera = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Isometry3d> worldFromBoard; // in the order of the plan's boards
};

/// What the robot recorded on its way through the poses, corners not measured yet.
struct CaptureSequence {
  std::vector<Stance> stances; // with their true placements
  std::vector<Capture> captures;
  std::vector<Exposure> exposures; // one per capture
};

/// Takes every pose of the plan and records all cameras, 30 ms apart, `samples` times: in place (rest), after leaving
/// the pose and coming back (reapproach), or pose after pose in as many stances (restand).
CaptureSequence recordCaptures(const SyntheticRobot& robot, const SimulationPlan& plan,
                               const std::vector<Placement>& boards, std::uint64_t seed);

/// A capture set and what is true about it.
struct Simulation {
  CaptureSet set;
  Truth truth;
  std::vector<Exposure> exposures; // one per capture
};

/// What the body and head ids of simulated robots begin with; their seed follows.
constexpr const char* syntheticIdPrefix = "synthetic-";

/// A robot of this drawing, with errors drawn at random, walks through the plan. The same seed gives the same.
Simulation simulate(const Robot& drawing, const SimulationPlan& plan, std::uint64_t seed);

} // namespace naocal
