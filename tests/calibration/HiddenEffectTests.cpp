#include "calibration/Calibration.hpp"
#include "data/CaptureSetFile.hpp"
#include "io/Files.hpp"

#include "SharedData.hpp"
#include "Solved.hpp"
#include "estimation/ModelBuilder.hpp"
#include "simulation/HandMadePoses.hpp"

#include <catch2/catch.hpp>
#include <functional>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

/// Estimate of an effect's first unknown.
Estimate estimateOf(const Measurements& measurements, const std::string& label) {
  const Model model = buildModel(measurements, {label});
  const CalibrationResult result = calibrate(measurements, model);
  CAPTURE(result.sentence, result.task ? result.task->sigma : 0, result.task ? result.task->bound : 0);
  CHECK(result.converged);
  CHECK(result.usable);
  const auto term = std::find_if(model.terms().begin(), model.terms().end(), [&](const Term& other) {
    return other.label() == labelFor(label, measurements.robot);
  });
  REQUIRE(term != model.terms().end());
  return result.estimates[term->first];
}

} // namespace

TEST_CASE("an effect that another simulator hid has its size within 3 sigma", "[slow]") {
  // Proves sign, formula and unit of five effects, including torque and centre of mass, against captures of an
  // independent simulator.
  const auto [name, place] =
      GENERATE(std::pair{"elasticity-knee", "LKneePitch"}, std::pair{"hysteresis-hip-roll", "LHipRoll"},
               std::pair{"link-thigh", "thigh"}, std::pair{"sole", "left"}, std::pair{"thermal-knee", "LKneePitch"});
  const auto folder = sharedData(std::string{"conformance/"} + name);
  if (!folder) {
    return;
  }
  const auto truth = nlohmann::json::parse(readFile(folder->string() + ".truth.json"))["effects"].back();
  const CaptureSet set = readCaptureSet(*folder).set;
  const Measurements measurements = buildMeasurements({set}, loadRobot(configurationDirectory(), set.model));
  const Estimate estimate = estimateOf(measurements, truth["effect"].get<std::string>() + "@" + place);
  INFO(name << ": " << estimate.value << " ± " << estimate.sigma);
  CHECK(std::abs(estimate.value - truth["size"].get<double>()) < 3 * estimate.sigma);
  CHECK(estimate.learned > 0.8);
}

TEST_CASE("a spring at the angle that it gave way to, and play that load or motion holds, have their sizes") {
  // Proves the formulas against captures of an independent simulator, and that "spring" is accepted as a name. The knee
  // of the previous test was simulated with the torque at the encoder angle: one formula fits both.
  const auto [name, label] =
      GENERATE(std::pair{"spring-knee", "spring@LKneePitch"}, std::pair{"gear-play", "gearPlay@LKneePitch"});
  const auto folder = sharedData(std::string{"conformance-2/"} + name);
  if (!folder) {
    return;
  }
  const auto truth = nlohmann::json::parse(readFile(folder->string() + ".truth.json"));
  const CaptureSet set = readCaptureSet(*folder).set;
  const Measurements measurements = buildMeasurements({set}, loadRobot(configurationDirectory(), set.model));
  const Estimate estimate = estimateOf(measurements, label);
  INFO(label << ": " << estimate.value << " ± " << estimate.sigma);
  CHECK(std::abs(estimate.value - truth["effects"][0][2].get<double>()) < 3 * estimate.sigma);
  CHECK(estimate.learned > 0.8);
}

TEST_CASE("what the simulator builds into a joint is estimated within 3 sigma, one motor's two joints included",
          "[slow]") {
  // Cross-checks the simulator's mechanisms and the effects: the simulator iterates a spring to equilibrium and takes
  // up play by load or motion; the calibration uses neither algorithm.
  const auto label = GENERATE("elasticity@LKneePitch", "spring@LHipYawPitch", "gearPlay@LHipPitch", "gearPlay@HeadYaw",
                              "hysteresis@LAnklePitch");
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan = handMadePlan(robot, 24);
  plan.flaw = label;
  const Simulation simulation = simulate(robot, plan, 3);
  const TrueEffect& truth = simulation.truth.effects.back();
  const Estimate estimate = estimateOf(buildMeasurements({simulation.set}, robot), label);
  INFO(label << ": " << estimate.value << " ± " << estimate.sigma);
  CHECK(labelFor(label, robot) == truth.effect + "@" + truth.at);
  CHECK(std::abs(estimate.value - truth.unknowns.front().value) < 3 * estimate.sigma);
  CHECK(estimate.learned > 0.8);
  plan.flaw = "gearPlay@nowhere";
  CHECK_THROWS_WITH(simulate(robot, plan, 3), Catch::Contains("gearPlay@LKneePitch, found gearPlay@nowhere"));
}

TEST_CASE("an effect that is larger than is plausible keeps its size") {
  // Proves that the prior does not shrink the estimate: the knee creeps by 0.12 mrad/s, twelve times the plausible
  // size.
  constexpr double creep = 1.2e-4; // [rad/s]
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  CaptureSet set = simulate(robot, handMadePlan(robot, 48), 5).set;
  const auto knee = std::find(set.jointNames.begin(), set.jointNames.end(), "LKneePitch") - set.jointNames.begin();
  for (Capture& capture : set.captures) {
    capture.joints.measured[static_cast<std::size_t>(knee)] -=
        creep * (capture.time - set.captures.front().time).count();
  }
  const Estimate estimate = estimateOf(buildMeasurements({set}, robot), "timeDrift@LKneePitch");
  INFO(estimate.value << " ± " << estimate.sigma);
  CHECK(std::abs(estimate.value - creep) < 3 * estimate.sigma);
  CHECK(estimate.sigma < 0.2 * creep);
}

TEST_CASE("a model that lacks an effect lies nearly as near to the pictures as it can") {
  // Proves it for joint scatter of 0.05 degrees and a focal length 4 % too long in the file: noise levels stay at the
  // true noise, and the displayed rms error is at most 10 % above the least possible one, found with a pixel noise of
  // 10 px.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan = handMadePlan(robot, 12);
  plan.mechanics.poseScatter = radians(0.05);
  CaptureSet set = simulate(robot, plan, 5).set;
  set.cameras.at("bottom").fx *= 1.04;
  set.cameras.at("bottom").fy *= 1.04;
  const Measurements measurements = buildMeasurements({set}, robot);
  const Model model = buildModel(measurements);
  CalibrationOptions least;
  least.noise.pixel = 10; // [px]; so large that only distances of corners count
  least.estimateNoise = least.testMissingEffects = least.robust = least.excludeDisplaced = false;
  const CalibrationResult result = calibrate(measurements, model);
  const double possible = calibrate(measurements, model, least).rmsPx;
  CHECK(possible > 3);
  CHECK(result.rmsPx < 1.1 * possible);
  CHECK(result.noise.pixel < 0.35);
  CHECK(result.noise.pose < radians(0.08));
}

TEST_CASE("a result that has the hidden effect predicts other poses better, joints' errors allowed for") {
  // Proves weightedError: with the knee's gain in the model it equals the corner noise (0.3 px per axis); without the
  // gain it is larger at the same noise; it is below the plain rms error.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  CaptureSet all = simulate(robot, handMadePlan(robot, 24), 5).set;
  const auto knee = std::find(all.jointNames.begin(), all.jointNames.end(), "LKneePitch") - all.jointNames.begin();
  CaptureSet learned = all, others = all;
  learned.captures.clear();
  others.captures.clear();
  for (Capture& capture : all.captures) {
    capture.joints.measured[static_cast<std::size_t>(knee)] *= 1.02;
    (std::stoi(capture.pose.substr(1)) % 2 == 0 ? learned : others).captures.push_back(capture);
  }
  const auto solvedWith = [&](const std::vector<std::string>& with) {
    Solved one{{learned}, buildMeasurements({learned}, robot), {}, {}};
    one.model = buildModel(one.measurements, with);
    one.result = calibrate(one.measurements, one.model);
    return one.stored();
  };
  const StoredResult without = solvedWith({}), with = solvedWith({"encoderGain@LKneePitch"});
  const double error = weightedError(with, {others}, robot, false, with.noise);
  const double before = weightedError(without, {others}, robot, false, with.noise);
  CHECK(error < before);
  CHECK(error == Approx(0.3 * std::sqrt(2)).epsilon(0.15));
  CHECK(error < compare(with, {others}, robot, false).all.rmsPx);
}

TEST_CASE("joints that come to rest a tenth of a degree off are allowed for in other poses' error") {
  // Proves that each pose's joint deflections are estimated before outliers are rejected: the plain error exceeds 1.5
  // px, the weighted error equals the corner noise.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan = handMadePlan(robot, 24);
  plan.mechanics.poseScatter = radians(0.1);
  const CaptureSet all = simulate(robot, plan, 5).set;
  CaptureSet learned = all, others = all;
  const auto isOther = [](const Capture& capture) { return std::stoi(capture.pose.substr(1)) % 2 == 1; };
  std::erase_if(learned.captures, isOther);
  std::erase_if(others.captures, std::not_fn(isOther));
  Solved one{{learned}, buildMeasurements({learned}, robot), {}, {}};
  one.model = buildModel(one.measurements);
  one.result = calibrate(one.measurements, one.model);
  const StoredResult result = one.stored();
  CHECK(weightedError(result, {others}, robot, false, result.noise) == Approx(0.3 * std::sqrt(2)).epsilon(0.15));
  CHECK(compare(result, {others}, robot, false).all.rmsPx > 1.5);
}

TEST_CASE("a tilted inertial unit is told from its readings, and only where there are any") {
  // Proves sign and size of the unit's roll, and the refusal without readings. Estimates of other unknowns are not
  // compared.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  Simulation simulation = simulate(robot, handMadePlan(robot, 12), 3);
  for (Capture& capture : simulation.set.captures) {
    *capture.imu += Eigen::Vector2d{-0.03, 0.02}; // small tilts about the same axes: reading minus tilt
  }
  const Estimate roll = estimateOf(buildMeasurements({simulation.set}, robot), "imuTilt@all");
  CHECK(std::abs(roll.value - 0.03) < 4 * roll.sigma + 0.001);
  CHECK(roll.sigma < 0.003);
  for (Capture& capture : simulation.set.captures) {
    capture.imu.reset();
  }
  CHECK_THROWS_WITH(buildModel(buildMeasurements({simulation.set}, robot), {"imuTilt@all"}),
                    Catch::Contains("no torso angles (imu) were recorded"));
}

TEST_CASE("an effect whose driver was not recorded is refused with the reason") {
  // Proves the messages, that '*' skips effects without their driver, and that torques on both feet require force
  // sensors.
  using Catch::Contains;
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  Simulation simulation = simulate(robot, handMadePlan(robot, 4, SupportFoot::both), 3);
  for (Capture& capture : simulation.set.captures) {
    capture.joints.temperature.clear();
    capture.fsr.reset();
  }
  const Measurements measurements = buildMeasurements({simulation.set}, robot);
  CHECK_THROWS_WITH(buildModel(measurements, {"thermalDrift@*"}), Contains("no temperatures were recorded"));
  CHECK_THROWS_WITH(buildModel(measurements, {"elasticity@LKneePitch"}), Contains("fsr"));
  CHECK_NOTHROW(buildModel(measurements, {"elasticity@HeadPitch"}));
  CHECK_NOTHROW(buildModel(measurements, {"elasticity@*"}));
}

} // namespace naocal
