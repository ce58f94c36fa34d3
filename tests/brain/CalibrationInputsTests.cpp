#include "brain/CalibrationInputs.hpp"

#include "RobotV6.hpp"
#include "simulation/HandMadePoses.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace naocal {

TEST_CASE("the gear's play stands where load and friction leave it, on every model of robot") {
  // Proves that the shipped model can be parsed, and its gear play against the play operator: a load above the gear's
  // friction holds the joint at one end of the gap, independent of the last motion; below it the joint lags behind that
  // motion.
  for (const char* name : {"V5", "V6"}) {
    const Robot robot = loadRobot(configurationDirectory(), name);
    const ModelFile model = loadCalibrationModel(configurationDirectory(), robot);
    CHECK(model.with == std::vector<std::string>{"playUnderLoad@*"});
    const Effect& gear = model.effects.back();
    REQUIRE(gear.name == "playUnderLoad");
    const std::size_t knee = *robot.jointIndex("LKneePitch");
    RobotSample instant;
    const auto gap = [&](double torque, double approach, double logFriction) {
      instant.torque = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(robot.joints.size()), torque);
      instant.approach = Eigen::VectorXd::Constant(instant.torque.size(), approach);
      ModelState modelState = nominalState(robot, {robot.joints.size(), robot.lengths.size(), 0});
      gear.correct(modelState, instant, knee, std::vector{0.01, logFriction});
      return modelState.angle(knee);
    };
    for (const double approach : {-1.0, 0.0, 1.0}) {
      CHECK(gap(0.5, approach, 0) == Approx(0.005));
      CHECK(gap(-0.5, approach, 0) == Approx(-0.005));
      CHECK(gap(0, approach, 0) == Approx(-0.005 * approach).margin(1e-6));
      CHECK(gap(0.5, approach, 2.5) == Approx(-0.005 * approach).margin(1e-6)); // friction torque 1.2 Nm
    }
  }
}

TEST_CASE("a calibration leaves out of its model what its captures cannot tell") {
  // Proves that one model file serves both legs: effects of the other leg and misspelt effects are listed and left out
  // instead of ending the calibration. On both feet, where the torques are unknown, only offsets and mounts remain.
  const auto standing = [](SupportFoot foot) {
    return buildMeasurements({simulate(v6(), handMadePlan(v6(), 2, foot), 5).set}, v6());
  };
  ModelFile model = loadCalibrationModel(configurationDirectory(), v6());
  model.with.insert(model.with.end(), {"elasticity@LKneePitch", "elasticity@RKneePitch", "elastisity@LKneePitch"});
  model.without = {"jointOffset@LHipRoll", "jointOffset@Nose"};
  const ReducedModel left = reduceModel(standing(SupportFoot::left), model);
  CHECK(left.model.with == std::vector<std::string>{"playUnderLoad@*", "elasticity@LKneePitch"});
  CHECK(left.model.without == std::vector<std::string>{"jointOffset@LHipRoll"});
  CHECK(left.leftOut == std::vector<std::string>{"with elasticity@RKneePitch", "with elastisity@LKneePitch",
                                                 "without jointOffset@Nose"});
  const ReducedModel right = reduceModel(standing(SupportFoot::right), model);
  CHECK(right.model.with == std::vector<std::string>{"playUnderLoad@*", "elasticity@RKneePitch"});
  const ReducedModel both = reduceModel(standing(SupportFoot::both), model);
  CHECK(both.model.with.empty());
  CHECK(both.leftOut.empty());
}

TEST_CASE("boards that share a marker are refused before a calibration begins") {
  // Proves the refusal, and that its message starts with the key and names a board.
  const auto boards = [](int second) {
    nlohmann::json list = nlohmann::json::array();
    for (const auto& [id, first] : {std::pair{"A", 0}, std::pair{"B", second}}) {
      list.push_back({{"id", id},
                      {"dictionary", "DICT_4X4_100"},
                      {"squaresX", 7},
                      {"squaresY", 5},
                      {"squareLength", 0.08},
                      {"markerLength", 0.06},
                      {"firstMarkerId", first}});
    }
    return list;
  };
  CHECK(boards(17).get<CalibrationBoards>().boards.size() == 2);
  try {
    boards(16).get<CalibrationBoards>();
    FAIL("was taken");
  } catch (const std::exception& error) {
    INFO(error.what());
    CHECK(std::string{error.what()}.find("boards") == 0);
    CHECK(std::string{error.what()}.find('A') != std::string::npos);
  }
}

} // namespace naocal
