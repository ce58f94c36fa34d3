#include "MeasuredArm.hpp"
#include "TemporaryFolder.hpp"

#include "calibration/Calibration.hpp"
#include "calibration/Uncertainty.hpp"
#include "data/CaptureSetFile.hpp"
#include "estimation/ModelBuilder.hpp"
#include "inference/ModelWindow.hpp"
#include "inference/WideModel.hpp"
#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"
#include "robot/RobotOfSet.hpp"
#include "simulation/Simulation.hpp"
#include "simulation/StandingPoses.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

/// Captures of a robot whose boards and feet stand where the set says: a model may then be empty.
Simulation surveyedSimulation(const Robot& robot) {
  SimulationPlan plan;
  plan.surveyed = true;
  plan.poses = planStandingPoses(robot, plan, SupportFoot::left, 4, 1);
  return simulate(robot, plan, 1);
}

Measurements measureV6() {
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  return buildMeasurements({surveyedSimulation(robot).set}, robot);
}

} // namespace

TEST_CASE("a calibration that asks for nothing is refused in one sentence") {
  // Proves for a NAO without any effect, and for a tracked arm without offsets, that the sentence says so; before, an
  // empty matrix ended the program.
  const Measurements measurements = measureV6();
  CHECK_THROWS_WITH(calibrate(measurements, buildModel(measurements, {}, {"*"})),
                    Catch::StartsWith("nothing to estimate: expected at least one"));
  const TemporaryFolder folder;
  writeArmSet(folder.path(), {.frames = false, .contacts = false});
  const CaptureSet set = readCaptureSet(folder.path()).set;
  const Measurements arm = buildMeasurements({set}, loadRobot(set));
  CHECK_THROWS_WITH(calibrate(arm, buildModel(arm, {}, {"jointOffset@*"})),
                    Catch::StartsWith("nothing to estimate: expected at least one"));
}

TEST_CASE("a marker that no joint moves leaves nothing to estimate") {
  // Proves that the refusal names the links where a tracker sees only the arm's base.
  const TemporaryFolder folder;
  writeArmSet(folder.path(), {.frames = false, .contacts = false});
  nlohmann::json set = nlohmann::json::parse(readFile(folder.path() / "captures.json"));
  for (nlohmann::json& marker : set["markers"]) {
    marker["link"] = "base";
  }
  writeAtomically(folder.path() / "captures.json", set.dump());
  const CaptureSet read = readCaptureSet(folder.path()).set;
  const Measurements measurements = buildMeasurements({read}, loadRobot(read));
  CHECK_THROWS_WITH(calibrate(measurements, buildModel(measurements)),
                    Catch::StartsWith("nothing to estimate: no joint moves what these captures measure"));
}

TEST_CASE("a model without unknowns has no weak directions") {
  // Proves that the list is empty, for a model without terms and for one that holds placements alone.
  CHECK(findWeakDirections(Model{}, CalibrationResult{}).empty());
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan;
  plan.poses = planStandingPoses(robot, plan, SupportFoot::left, 4, 1);
  const Measurements measurements = buildMeasurements({simulate(robot, plan, 1).set}, robot);
  const Model placements = buildModel(measurements, {}, {"*"});
  REQUIRE(placements.unknownCount() > 0);
  CalibrationResult result;
  result.covariance.setIdentity(eigenIndex(placements.unknownCount()), eigenIndex(placements.unknownCount()));
  CHECK(findWeakDirections(placements, result).empty());
}

TEST_CASE("the window of explanations survives models without unknowns, candidates or curves") {
  // Proves that the window holds at least the model alone, with weights that sum to 1. Whether the weights of full
  // problems are right is tested elsewhere.
  const Measurements measurements = measureV6();
  const Noise noise;
  const bool curves = GENERATE(false, true);
  const bool hasUnknowns = GENERATE(false, true);
  const Model model = hasUnknowns ? buildModel(measurements) : Model{};
  const Residuals residuals{measurements, model, noise, {}};
  const FittedPoint point{residuals.startState(Eigen::VectorXd::Zero(eigenIndex(model.unknownCount()))), noise, {}};
  const WideModel wide{measurements, model, {}, point, curves};
  const ModelWindow window = searchModelWindow({wide.problem(), noise});
  REQUIRE_FALSE(window.models.empty());
  CHECK(window.mean.size() == eigenIndex(model.unknownCount()));
  CHECK(window.groupWeights.size() == wide.problem().groups.size());
  double sum = 0;
  for (const WindowModel& one : window.models) {
    sum += one.weight;
  }
  CHECK(sum == Approx(1));
}

TEST_CASE("a model that lies a billion pixels off is still the likeliest of its window") {
  // Proves that the likeliest model is kept where its cost swallows the width of the window, and that costs beyond all
  // numbers are refused in a sentence; before, the first element of an empty list was read.
  Measurements measurements = measureV6();
  const double far = GENERATE(1e9, 1e160);
  for (ImageObservation& picture : measurements.pictures) {
    for (BoardObservation& observation : picture.observations) {
      for (CornerBlock& block : observation.corners) {
        block.u += far * block.present;
      }
    }
  }
  const Model model = buildModel(measurements);
  const Noise noise;
  const Residuals residuals{measurements, model, noise, {}};
  const FittedPoint point{residuals.startState(Eigen::VectorXd::Zero(eigenIndex(model.unknownCount()))), noise, {}};
  const WideModel wide{measurements, model, {}, point, true};
  if (far < 1e100) {
    CHECK_FALSE(searchModelWindow({wide.problem(), noise}).models.empty());
  } else {
    CHECK_THROWS_WITH(searchModelWindow({wide.problem(), noise}), Catch::StartsWith("the misfit is no finite number"));
  }
}

} // namespace naocal
