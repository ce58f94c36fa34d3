#pragma once

#include "RobotV6.hpp"
#include "poses/PosePlan.hpp"
#include "poses/criteria/PlanOptions.hpp"
#include "simulation/SimulationPlan.hpp"

/// Options of a plan that takes seconds.
inline naocal::PlanOptions quickOptions(std::size_t poses, naocal::SupportFoot foot = naocal::SupportFoot::left) {
  naocal::PlanOptions options;
  options.poses.supportFoot = foot;
  options.poses.count = poses;
  options.poses.maxAttempts = 40'000;
  options.poses.sampling = naocal::SamplingMethod::even;
  options.maxCandidates = 300;
  options.starts = 1;
  options.rounds = 1;
  options.refinements = 150;
  return options;
}

/// A plan with the simulator's boards.
inline naocal::PosePlan quickPlan(const naocal::PlanOptions& options) {
  const naocal::SimulationPlan scene;
  return naocal::planPoses(naocal::v6(), {scene.boards, scene.cameras}, options);
}

inline double largest(const std::map<std::string, double>& sigmas) {
  double result = 0;
  for (const auto& [joint, sigma] : sigmas) {
    result = std::max(result, sigma);
  }
  return result;
}
