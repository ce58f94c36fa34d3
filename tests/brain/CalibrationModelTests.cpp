#include "brain/CalibrationModel.hpp"

#include "../RobotV6.hpp"

#include <catch2/catch.hpp>

namespace naocal {

TEST_CASE("the gear's play stands where load and friction leave it, on every model of robot") {
  // Proves that what is shipped can be read, and against a play operator by hand: a load above the gear's friction holds
  // the joint at one end whatever the last motion was; under a lesser one it lags behind that motion.
  for (const char* name : {"V5", "V6"}) {
    const Robot robot = loadRobot(configurationDirectory(), name);
    const ModelFile model = calibrationModel(configurationDirectory(), robot);
    CHECK(model.with == std::vector<std::string>{"gearPlay@*"});
    const Effect& gear = model.effects.back();
    REQUIRE(gear.name == "gearPlay");
    const std::size_t knee = *robot.jointIndex("LKneePitch");
    Instant instant;
    const auto gap = [&](double torque, double approach, double logFriction) {
      instant.torque = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(robot.joints.size()), torque);
      instant.approach = Eigen::VectorXd::Constant(instant.torque.size(), approach);
      Belief belief = drawnBelief(robot, {robot.joints.size(), robot.lengths.size(), 0});
      gear.correct(belief, instant, knee, std::vector{0.01, logFriction});
      return belief.angle(knee);
    };
    for (const double approach : {-1.0, 0.0, 1.0}) {
      CHECK(gap(0.5, approach, 0) == Approx(0.005));
      CHECK(gap(-0.5, approach, 0) == Approx(-0.005));
      CHECK(gap(0, approach, 0) == Approx(-0.005 * approach).margin(1e-6));
      CHECK(gap(0.5, approach, 2.5) == Approx(-0.005 * approach).margin(1e-6)); // a gear that holds 1.2 Nm
    }
  }
}

TEST_CASE("on both feet no load is known, so a calibration there has offsets and mounts only") {
  // Proves that one stance on both feet is enough to leave the model's effects out, and none on one foot.
  const ModelFile model = calibrationModel(configurationDirectory(), v6());
  Measurements measurements{.robot = v6()};
  measurements.standings = {{.supportFoot = SupportFoot::left}, {.supportFoot = SupportFoot::right}};
  CHECK(modelFor(measurements, model).with == model.with);
  measurements.standings.push_back({.supportFoot = SupportFoot::both});
  CHECK(modelFor(measurements, model).with.empty());
}

} // namespace naocal
