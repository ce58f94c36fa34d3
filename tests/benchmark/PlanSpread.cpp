#include "poses/PlanSpread.hpp"
#include "math/Angles.hpp"
#include "poses/criteria/PlanOptions.hpp"

#include <cstdlib>
#include <fmt/core.h>

// Compares a plan's predicted sigmas with the spread of simulated calibrations, joint by joint. Usage: benchmark_spread
// [ROBOTS] [left|right|both]. 500 robots (the default) determine a spread to 3 % (1 sigma).

int main(int count, char** arguments) {
  using namespace naocal;
  const std::uint64_t robots = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 500;
  const std::string support = count > 2 ? arguments[2] : "left";
  PlanOptions options;
  options.poses.supportFoot = support == "both"    ? SupportFoot::both
                              : support == "right" ? SupportFoot::right
                                                   : SupportFoot::left;
  options.poses.count = 8;
  options.poses.maxAttempts = 200'000;
  options.poses.sampling = SamplingMethod::even;
  const SimulationPlan scene;
  const PosePlan plan = planPoses(v6(), {scene.boards, scene.cameras}, options);
  fmt::print("{:<14} {:>12} {:>12} {:>8}\n", "offset", "predicted", "spread", "ratio");
  for (const auto& [joint, spread] : simulatedSpread(plan, robots)) {
    const double predicted = plan.sigmaOfRobots.at(joint);
    fmt::print("{:<14} {:>10.4f} ° {:>10.4f} ° {:>8.3f}\n", joint, degrees(predicted), degrees(spread),
               spread / predicted);
  }
}
