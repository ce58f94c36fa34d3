#include "calibration/Calibration.hpp"

#include "TemporaryFolder.hpp"
#include "calibration/Initialization.hpp"
#include "calibration/Outliers.hpp"
#include "calibration/Prediction.hpp"
#include "calibration/Uncertainty.hpp"
#include "estimation/ModelBuilder.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"
#include "simulation/HandMadePoses.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

namespace naocal {
namespace {

struct Made {
  explicit Made(std::uint64_t seed = 3, int poses = 8, int samples = 2, RepeatKind kind = RepeatKind::reapproach)
      : robot{loadRobot(configurationDirectory(), "V6")} {
    SimulationPlan plan = handMadePlan(robot, poses);
    plan.samples = samples;
    plan.repeatKind = kind;
    simulation = simulate(robot, plan, seed);
    measurements = buildMeasurements({simulation.set}, robot);
    model = buildModel(measurements);
  }
  Robot robot;
  Simulation simulation;
  Measurements measurements;
  Model model;
};

} // namespace

TEST_CASE("shuffled captures give the same answer to the last digit") {
  // Proves that all stages, including the noise estimation, are independent of the captures' order.
  const Made made;
  CaptureSet shuffled = made.simulation.set;
  std::shuffle(shuffled.captures.begin(), shuffled.captures.end(), std::mt19937{5});
  const Measurements other = buildMeasurements({shuffled}, made.robot);
  const CalibrationResult a = calibrate(made.measurements, made.model), b = calibrate(other, buildModel(other));
  CHECK(a.unknowns == b.unknowns);
  CHECK(a.covariance == b.covariance);
}

TEST_CASE("a board whose views were all set aside does not spoil the placements") {
  // Proves that views without weight are no sights to place a board by.
  Made made;
  for (std::size_t picture = 0; picture < made.measurements.pictures.size(); ++picture) {
    for (std::size_t i = 0; i < made.measurements.pictures[picture].observations.size(); ++i) {
      if (made.measurements.pictures[picture].observations[i].view.board() == 0) {
        excludeObservation(made.measurements, {picture, i});
      }
    }
  }
  const Eigen::VectorXd start = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(made.model.unknownCount()));
  CHECK(initializePlacements(made.measurements, made.model, start).allFinite());
}

TEST_CASE("a board of which only a row of corners is seen is placed where it lies") {
  // Proves that place and yaw follow from where the corners' rays meet the floor, as no pose in the camera follows from
  // corners on a line: to what 0.3 px do at 1 to 2 m from the camera, joints as read.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan = handMadePlan(robot, 8);
  plan.offsetRange = plan.mountRange = 0;
  Measurements measurements = buildMeasurements({simulate(robot, plan, 4).set}, robot);
  const Model model = buildModel(measurements);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(eigenIndex(model.unknownCount()));
  const Eigen::VectorXd fromAll = initializePlacements(measurements, model, zero);
  for (ImageObservation& picture : measurements.pictures) {
    for (BoardObservation& observation : picture.observations) {
      const double row = observation.corners.front().y[0];
      for (CornerBlock& block : observation.corners) {
        for (Eigen::Index i = 0; i < 4; ++i) {
          block.present[i] *= std::abs(block.y[i] - row) < 1e-6 ? 1 : 0;
        }
      }
    }
  }
  const Eigen::VectorXd fromRows = initializePlacements(measurements, model, zero);
  int placed = 0;
  for (const Term& term : model.terms()) {
    if (term.effect.placeKind == PlaceKind::board && term.isPlacement) {
      const Eigen::Vector3d all = fromAll.segment<3>(eigenIndex(term.first)),
                            row = fromRows.segment<3>(eigenIndex(term.first));
      CAPTURE(term.label(), all.transpose(), row.transpose());
      CHECK((all - row).head<2>().norm() < 0.05);                                   // m
      CHECK(std::abs(std::remainder(all[2] - row[2], 2 * std::numbers::pi)) < 0.1); // rad
      ++placed;
    }
  }
  CHECK(placed == std::ssize(measurements.targets) - 1); // the first is the reference
}

TEST_CASE("stances that hold only later samples of a pose are aligned before the search too") {
  // Proves that the placement of a robot that stands anew for every sample is initialised near the minimum: without it,
  // the search takes 25 iterations or more, or cannot start.
  for (const std::uint64_t seed : {2, 3, 5}) {
    const Made made{seed, 3, 3, RepeatKind::restand};
    const CalibrationResult result = calibrate(made.measurements, made.model);
    CHECK(result.converged);
    CHECK(result.iterations <= 20);
  }
}

TEST_CASE("joints and cameras in turns end where both together end") {
  // Proves that the thesis' alternating search reaches the same minimum in more iterations.
  const Made made;
  CalibrationOptions together, inTurns;
  together.estimateNoise = inTurns.estimateNoise = false;
  inTurns.alternate = true;
  const CalibrationResult a = calibrate(made.measurements, made.model, together);
  const CalibrationResult b = calibrate(made.measurements, made.model, inTurns);
  const Eigen::VectorXd sigmas = a.covariance.diagonal().cwiseSqrt();
  CHECK((a.unknowns - b.unknowns).cwiseQuotient(sigmas).cwiseAbs().maxCoeff() < 0.05);
  CHECK(b.iterations > a.iterations);
}

TEST_CASE("random restarts find nothing better on an ordinary set") {
  // Proves that on this set eight restarts find no lower minimum, and that restarts are counted.
  const Made made;
  CalibrationOptions options;
  options.restarts = 8;
  const CalibrationResult result = calibrate(made.measurements, made.model, options);
  CHECK(result.restartsTried == 8);
  CHECK_FALSE(result.restartsChanged);
  CHECK(result.usable);
}

TEST_CASE("what one pose cannot tell is said in words and makes the result unusable") {
  // Proves that with too few poses the result lists weak directions, some unknowns are learned by less than half, and
  // it is not usable.
  const Made made{3, 1, 1};
  const CalibrationResult result = calibrate(made.measurements, made.model);
  CHECK_FALSE(result.usable);
  REQUIRE_FALSE(result.weak.empty());
  CHECK_FALSE(result.weak.front().parts.empty());
  CHECK(std::any_of(result.estimates.begin(), result.estimates.end(),
                    [](const Estimate& estimate) { return estimate.learned < 0.5; }));
}

TEST_CASE("a result file gives back what was written and predicts other captures of the robot") {
  // Proves the round trip of values through RESULT.json, and the comparison: rms error on captures not used for the fit
  // is below 1.5 px, a tenth of the nominal error.
  const Made made{4, 12};
  const CalibrationResult result = calibrate(made.measurements, made.model);
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "result.json";
  writeAtomically(file, resultJson({made.measurements, made.model, result}, {{"x"}, {"y"}}).dump());
  const StoredResult stored = readResult(file);
  CHECK(stored.usable == result.usable);
  std::size_t found = 0;
  for (std::size_t i = 0; i < made.model.unknownCount(); ++i) {
    if (const auto value = stored.values.find(made.model.names()[i]); value != stored.values.end()) {
      CHECK(value->second == result.estimates[i].value);
      ++found;
    }
  }
  CHECK(found > 0);
  CHECK(found == stored.values.size());
  SimulationPlan later = handMadePlan(made.robot, 6);
  later.poses = handMadePoses(made.robot, SupportFoot::left, 6, 99);
  later.robotSeed = 4;
  const Comparison comparison = compare(stored, {simulate(made.robot, later, 77).set}, made.robot, false);
  CHECK(comparison.nominal.rmsPx > 10 * comparison.all.rmsPx);
  CHECK(comparison.all.rmsPx < 1.5);
  CHECK(comparison.ignored.empty());
}

TEST_CASE("captures without any corner and terms without any place are refused with a sentence") {
  // Proves that empty or inconsistent input throws InputError instead of giving a result.
  Made made;
  CaptureSet nothing = made.simulation.set;
  for (Capture& capture : nothing.captures) {
    capture.corners->clear();
  }
  const Measurements empty = buildMeasurements({nothing}, made.robot);
  CHECK_THROWS_AS(calibrate(empty, buildModel(empty)), InputError);
  CHECK_THROWS_WITH(buildModel(made.measurements, {"jointOffset@LKnee"}), Catch::Contains("jointOffset@LKneePitch"));
  CaptureSet other = made.simulation.set;
  other.bodyId = "somebody else";
  CHECK_THROWS_WITH(buildMeasurements({made.simulation.set, other}, made.robot), Catch::Contains("one robot"));
}

TEST_CASE("a fit that bends joints until it sees what lies behind the camera is refused") {
  // Proves the refusal for a head that its offset turns by 180 degrees and its deflections turn back: at the encoder
  // readings the corners lie behind the camera and have no residual.
  const Made made;
  const Noise noise{0.3, 6e-4, 1e-3};
  const Residuals residuals{made.measurements, made.model, noise};
  const std::size_t head = made.robot.jointIndex("HeadYaw").value();
  Fit fit{noise, {}, {}};
  fit.minimum.state = residuals.startState(calibrate(made.measurements, made.model).unknowns);
  fit.minimum.linear = residuals.linearize(fit.minimum.state).value();
  for (std::size_t pose = 0; pose < fit.minimum.linear.poses.size(); ++pose) {
    const PoseSystem& system = fit.minimum.linear.poses[pose];
    Eigen::VectorXd turned = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(system.joints.size()));
    for (std::size_t i = 0; i < system.joints.size(); ++i) {
      turned[static_cast<Eigen::Index>(i)] = system.joints[i] == head ? std::numbers::pi : 0;
    }
    const Eigen::MatrixXd root = jointErrorRoot(system, noise);
    fit.minimum.state.deflections[pose] = root.lu().solve(turned);
  }
  for (const Term& term : made.model.terms()) {
    if (term.label() == "jointOffset@HeadYaw") {
      fit.minimum.state.unknowns[static_cast<Eigen::Index>(term.first)] += std::numbers::pi;
    }
  }
  REQUIRE(residuals.linearize(fit.minimum.state)); // at the deflected joints the corners are visible
  CHECK_THROWS_AS(estimateUncertainty(made.measurements, made.model, fit, {noise}), InputError);
}

} // namespace naocal
