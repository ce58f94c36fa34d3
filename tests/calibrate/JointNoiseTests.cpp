#include "calibrate/Calibration.hpp"
#include "geometry/Angles.hpp"
#include "synthetic/Simulation.hpp"
#include "synthetic/StandingPoses.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace naocal {

TEST_CASE("repeats tell what scatters from pose to pose and what at every approach") {
  // Proves that the restricted likelihood is searched to its peak: gears that stick differently in every pose (0.06
  // degrees) and at every approach (0.08) are told apart and sized, averaged over six robots with 24 poses each. One
  // robot's levels vary by some 10 percent.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan;
  plan.poses = standingPoses(robot, plan, SupportFoot::left, 24, 1);
  plan.repeatKind = RepeatKind::reapproach;
  plan.mechanics.poseScatter = radians(0.06);
  plan.mechanics.approachScatter = radians(0.08);
  constexpr int robots = 6;
  double encoder = 0, pose = 0;
  for (std::uint64_t seed = 1; seed <= robots; ++seed) {
    const Measurements measurements = measurementsOf({simulate(robot, plan, seed).set}, robot);
    const Noise noise = calibrate(measurements, makeModel(measurements)).noise;
    encoder += noise.encoder / robots;
    pose += noise.pose / robots;
  }
  const double reading = std::hypot(encoderStep / std::sqrt(12.0), plan.mechanics.encoderDither);
  CHECK(encoder == Approx(std::hypot(reading, plan.mechanics.approachScatter)).epsilon(0.1));
  CHECK(pose == Approx(plan.mechanics.poseScatter).epsilon(0.2));
}

} // namespace naocal
