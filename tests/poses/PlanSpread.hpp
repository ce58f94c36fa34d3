#pragma once

#include "RobotV6.hpp"
#include "calibration/Calibration.hpp"
#include "estimation/ModelBuilder.hpp"
#include "poses/PosePlan.hpp"
#include "simulation/Simulation.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

/// RMS error of each joint's offset over simulated robots with unknown offsets, mounts and placements, calibrated with
/// a plan's poses and boards [rad]. The simulator has its own mechanics and noise.
inline std::map<std::string, double> simulatedSpread(const naocal::PosePlan& plan, std::uint64_t robots) {
  using namespace naocal;
  SimulationPlan scene;
  scene.boards = plan.boards;
  scene.samples = 1;
  for (const ProposedPose& pose : plan.poses) {
    scene.poses.push_back({"P" + std::to_string(scene.poses.size()), pose.pose.supportFoot, pose.pose.angles, {}});
  }
  std::map<std::string, double> squares;
  for (std::uint64_t seed = 1; seed <= robots; ++seed) {
    const Simulation simulation = simulate(v6(), scene, seed);
    const Measurements measurements = buildMeasurements({simulation.set}, v6());
    const Model model = buildModel(measurements);
    const CalibrationResult result = calibrate(measurements, model);
    for (const auto& [name, sigma] : plan.sigmaOfRobots) {
      const std::string label = "jointOffset@" + name;
      const auto term = std::find_if(model.terms().begin(), model.terms().end(),
                                     [&](const Term& each) { return each.label() == label; });
      if (term == model.terms().end()) {
        throw std::runtime_error{"no " + label};
      }
      const double error = result.unknowns[static_cast<Eigen::Index>(term->first)] -
                           simulation.truth.value("jointOffset", name, "o").value();
      squares[name] += error * error / static_cast<double>(robots);
    }
  }
  for (auto& [name, square] : squares) {
    square = std::sqrt(square);
  }
  return squares;
}
