#include "calibration/Calibration.hpp"
#include "calibration/ModelUncertainty.hpp"
#include "estimation/ModelBuilder.hpp"
#include "inference/Evidence.hpp"
#include "math/Angles.hpp"
#include "math/LinearAlgebra.hpp"
#include "simulation/Simulation.hpp"
#include "simulation/StandingPoses.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <optional>

namespace naocal {
namespace {

SimulationPlan planOf(const Robot& robot, std::size_t poses) {
  SimulationPlan plan;
  plan.poses = planStandingPoses(robot, plan, SupportFoot::left, poses, 1);
  return plan;
}

} // namespace

TEST_CASE("where one number of an effect is beyond plausible, its others may be, too") {
  // Proves that an effect's priors widen together: the captures determine an eccentricity's sine part at three
  // plausible sizes and say nothing of its cosine part, which the joint's offset imitates. An effect of plausible size
  // keeps its priors.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  const Simulation simulation = simulate(robot, planOf(robot, 4), 1);
  const Measurements measurements = buildMeasurements({simulation.set}, robot);
  const Model model = buildModel(measurements, {"encoderEccentricity@LKneePitch"});
  const Term& effect = *model.find("encoderEccentricity@LKneePitch");
  const Eigen::VectorXd sigmas = effect.sigmas();
  const auto widened = [&](double sineInSigmas) {
    Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(eigenIndex(model.unknownCount()));
    Eigen::VectorXd variances = model.sigmas().cwiseAbs2();
    unknowns[eigenIndex(effect.first)] = sineInSigmas * sigmas[0];
    variances[eigenIndex(effect.first)] *= 0.1; // determined by the captures
    return widenPriors(model, unknowns, variances);
  };
  const std::optional<Model> wide = widened(3);
  REQUIRE(wide);
  CHECK(wide->find("encoderEccentricity@LKneePitch")->sigmas().isApprox(widestWidth.width * sigmas));
  CHECK_FALSE(widened(0.5));
}

TEST_CASE("a camera that sits elsewhere is no scatter of joints", "[slow]") {
  // Proves that noise levels are estimated with the widest model: with both cameras displaced by up to 3 mm, the pose
  // noise of joints without stiction stays below 0.05 degrees, the rms error is within 50 % of the fit with fixed
  // noise, averaged intervals cover at least 88 % of the offsets, and no usable result is wrong by more than 3.5 sigma.
  // Ten robots; with levels estimated from the plain model, most of them reach the level's bound.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan = planOf(robot, 20);
  plan.mountShiftRange = 0.003;
  int inside = 0, all = 0, vouched = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    plan.robotSeed = plan.boardSeed = seed;
    const Simulation simulation = simulate(robot, plan, seed);
    const Measurements measurements = buildMeasurements({simulation.set}, robot);
    const Model model = buildModel(measurements);
    const CalibrationResult result = calibrate(measurements, model);
    const CalibrationResult fixed =
        calibrate(measurements, model, {.estimateNoise = false, .testMissingEffects = false});
    CAPTURE(seed, degrees(result.noise.pose), result.rmsPx, fixed.rmsPx);
    CHECK(result.noise.pose < radians(0.05));
    CHECK(result.rmsPx < 1.5 * fixed.rmsPx);
    for (const Term& term : model.terms()) {
      if (term.effect.name == "jointOffset") {
        const double truth = simulation.truth.value("jointOffset", term.placeName, "o").value();
        const Estimate& estimate = result.estimates[term.first];
        const auto [low, high] = estimate.interval();
        inside += low <= truth && truth <= high;
        ++all;
        vouched += result.usable && std::abs(truth - estimate.best()) > 3.5 * estimate.bestSigma();
      }
    }
  }
  CAPTURE(inside, all);
  CHECK(inside >= 0.88 * all);
  CHECK(vouched == 0);
}

TEST_CASE("joints that stick hide no camera that sits elsewhere", "[slow]") {
  // Proves that the fit with joints held still is tried: cameras are displaced by up to 14 mm, gears stick by 0.1
  // degrees, and deflected joints lead the search to a minimum more than twice as far from the pictures as a fit with
  // fixed noise.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  constexpr std::uint64_t seed = 4;
  SimulationPlan plan;
  plan.samples = 2;
  plan.mountShiftRange = 0.014;
  plan.mechanics.poseScatter = radians(0.1);
  plan.poses = planStandingPoses(robot, plan, SupportFoot::left, 20, seed);
  const Simulation simulation = simulate(robot, plan, seed);
  const Measurements measurements = buildMeasurements({simulation.set}, robot);
  const Model model = buildModel(measurements);
  const CalibrationResult result = calibrate(measurements, model);
  const CalibrationResult fixed = calibrate(measurements, model, {.estimateNoise = false, .testMissingEffects = false});
  CHECK(result.rmsPx < 1.2 * fixed.rmsPx);
}

TEST_CASE("joints that scatter more than noise may are a misfit of that size, however sharp the corners", "[slow]") {
  // Proves that the misfit remains accurate with loose joints and precise corners: joint scatter is 0.3 degrees, pose
  // noise is bounded by 0.15 and the encoder noise is 0.025, so chi2 per degree of freedom should be about 4; with 8
  // poses a factor of two is allowed.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan = planOf(robot, 8);
  plan.samples = 2;
  plan.repeatKind = RepeatKind::reapproach;
  plan.corners.pixel = 0.017;
  plan.mechanics.poseScatter = radians(0.3);
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    plan.robotSeed = plan.boardSeed = seed;
    const Simulation simulation = simulate(robot, plan, seed);
    const Measurements measurements = buildMeasurements({simulation.set}, robot);
    const CalibrationResult result = calibrate(measurements, buildModel(measurements));
    CAPTURE(seed, result.misfit, result.misfitLeft, degrees(result.noise.pose));
    CHECK(result.misfit > 1.5);
    CHECK(result.misfit < 8);
    CHECK(result.misfitLeft <= result.misfit);
    CHECK_FALSE(result.usable);
  }
}

} // namespace naocal
