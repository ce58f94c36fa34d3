#include "calibration/Calibration.hpp"
#include "estimation/ModelBuilder.hpp"
#include "math/Angles.hpp"
#include "simulation/Simulation.hpp"
#include "simulation/StandingPoses.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace naocal {

TEST_CASE("repeats tell what scatters from pose to pose and what at every approach", "[slow]") {
  // Proves that the REML search separates and estimates stiction per pose (0.06 degrees) and per approach (0.08),
  // averaged over six robots with 24 poses each. The levels of a single robot scatter by about 10 %.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan;
  plan.poses = planStandingPoses(robot, plan, SupportFoot::left, 24, 1);
  plan.repeatKind = RepeatKind::reapproach;
  plan.mechanics.poseScatter = radians(0.06);
  plan.mechanics.approachScatter = radians(0.08);
  constexpr int robots = 6;
  double reapproach = 0, pose = 0;
  for (std::uint64_t seed = 1; seed <= robots; ++seed) {
    const Measurements measurements = buildMeasurements({simulate(robot, plan, seed).set}, robot);
    const Noise noise = calibrate(measurements, buildModel(measurements)).noise;
    reapproach += noise.reapproach / robots;
    pose += noise.pose / robots;
  }
  CHECK(reapproach == Approx(plan.mechanics.approachScatter).epsilon(0.1));
  CHECK(pose == Approx(plan.mechanics.poseScatter).epsilon(0.2));
}

namespace {

/// Levels and effects by the likeliest explanation of poses taken once.
CalibrationResult calibrateOnce(const Robot& robot, const SimulationPlan& plan, std::uint64_t seed) {
  const Measurements measurements = buildMeasurements({simulate(robot, plan, seed).set}, robot);
  return calibrate(measurements, buildModel(measurements));
}

/// A robot that takes its poses three times, stands anew and takes them three times again: stiction is drawn anew for
/// every stance.
CaptureSet restood(const Robot& robot, SimulationPlan plan, std::uint64_t seed) {
  plan.robotSeed = plan.boardSeed = seed;
  CaptureSet set = simulate(robot, plan, 2 * seed).set;
  plan.firstStance = 1;
  CaptureSet again = simulate(robot, plan, 2 * seed + 1).set;
  const Seconds later = set.captures.back().time + Seconds{30};
  set.stances.insert(set.stances.end(), again.stances.begin(), again.stances.end());
  for (Capture& capture : again.captures) {
    capture.id += 100'000;
    capture.repeat += plan.samples;
    capture.time += later;
    capture.repeatKind = capture.repeat == plan.samples ? RepeatKind::restand : RepeatKind::reapproach;
    set.captures.push_back(std::move(capture));
  }
  return set;
}

} // namespace

TEST_CASE("a robot that was put down anew tells what standing anew changes", "[slow]") {
  // Proves that scatter per stance (0.06 degrees) is attributed to the stance, not to approaches or poses, and that the
  // stance level is zero with a single stance.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan;
  plan.poses = planStandingPoses(robot, plan, SupportFoot::left, 24, 1);
  plan.repeatKind = RepeatKind::reapproach;
  plan.mechanics.poseScatter = radians(0.06);
  constexpr int robots = 4;
  Noise mean{.pixel = 0, .encoder = 0};
  for (std::uint64_t seed = 1; seed <= robots; ++seed) {
    const Measurements measurements = buildMeasurements({restood(robot, plan, seed)}, robot);
    const Noise noise = calibrate(measurements, buildModel(measurements)).noise;
    mean.reapproach += noise.reapproach / robots;
    mean.pose += noise.pose / robots;
    mean.stance += noise.stance / robots;
  }
  CHECK(mean.reapproach < 0.25 * plan.mechanics.poseScatter);
  CHECK(mean.stance == Approx(plan.mechanics.poseScatter).epsilon(0.2));
  CHECK(mean.pose < 0.4 * plan.mechanics.poseScatter);
  const Measurements once = buildMeasurements({simulate(robot, plan, 2).set}, robot);
  CHECK(calibrate(once, buildModel(once)).noise.stance == 0);
}

TEST_CASE("scatter is told beside a missing spring where every pose was taken once", "[slow]") {
  // Proves that noise levels are compared at one linearisation point: with the spring fitted, scatter of 0.04 degrees is
  // estimated, not zero, and the spring alone explains the rest.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan;
  plan.poses = planStandingPoses(robot, plan, SupportFoot::left, 24, 1);
  plan.samples = 1;
  plan.mechanics.poseScatter = radians(0.04);
  plan.flaw = "elasticity@LKneePitch";
  constexpr int robots = 4;
  double pose = 0;
  for (std::uint64_t seed = 1; seed <= robots; ++seed) {
    const CalibrationResult result = calibrateOnce(robot, plan, seed);
    pose += result.noise.pose / robots;
    REQUIRE_FALSE(result.explanations.empty());
    CHECK(result.explanations.front().effects == std::vector<std::string>{plan.flaw});
  }
  CHECK(pose == Approx(plan.mechanics.poseScatter).epsilon(0.2));
}

} // namespace naocal
