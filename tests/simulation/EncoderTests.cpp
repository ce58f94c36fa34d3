#include "RobotV6.hpp"
#include "simulation/HandMadePoses.hpp"
#include "simulation/SyntheticRobot.hpp"

#include <catch2/catch.hpp>

using namespace naocal;

namespace {

constexpr double step = 2 * std::numbers::pi / 4096; // of a NAO's encoders [rad]

/// Readings minus (true angle + offset), for all captures and joints [rad].
std::vector<double> encoderErrors(const SimulationPlan& plan) {
  const Simulation simulation = simulate(v6(), plan, 1);
  std::vector<double> errors;
  for (std::size_t capture = 0; capture < simulation.set.captures.size(); ++capture) {
    for (std::size_t joint = 0; joint < v6().joints.size(); ++joint) {
      const std::string& motor = v6().joints[v6().joints[joint].motor].name;
      errors.push_back(simulation.set.captures[capture].joints.measured[joint] -
                       simulation.exposures[capture].joints[static_cast<Eigen::Index>(joint)] -
                       *simulation.truth.value("jointOffset", motor, "o"));
    }
  }
  return errors;
}

double meanSquare(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) {
    sum += value * value;
  }
  return sum / static_cast<double>(values.size());
}

/// Number of joint readings that differ from the previous sample of the same pose and camera.
int changedReadings(const SimulationPlan& plan) {
  const Simulation simulation = simulate(v6(), plan, 1);
  int changed = 0;
  for (const Capture& capture : simulation.set.captures) {
    for (const Capture& before : simulation.set.captures) {
      if (before.pose == capture.pose && before.camera == capture.camera && before.repeat + 1 == capture.repeat) {
        for (std::size_t joint = 0; joint < v6().joints.size(); ++joint) {
          changed += before.joints.measured[joint] != capture.joints.measured[joint];
        }
      }
    }
  }
  return changed;
}

} // namespace

TEST_CASE("encoders count in whole steps of 1/4096 turn") {
  // Proves that readings are multiples of a step. Their values are not tested.
  const Simulation simulation = simulate(v6(), handMadePlan(v6()), 1);
  for (const Capture& capture : simulation.set.captures) {
    for (const double angle : capture.joints.measured) {
      REQUIRE(std::abs(std::remainder(angle, step)) < 1e-12);
    }
  }
}

TEST_CASE("an encoder shows the true angle plus the offset, wrong by a step's rounding and a little dither") {
  // Proves sign and size of the offset, and that errors over many approaches have the variance of rounding (step^2 /
  // 12) plus dither: 10,000 errors, so the mean square is known to 1 %.
  SimulationPlan plan = handMadePlan(v6(), 80);
  plan.repeatKind = RepeatKind::reapproach;
  const std::vector<double> errors = encoderErrors(plan);
  const double expected = step * step / 12 + std::pow(plan.mechanics.encoderDither, 2);
  CHECK(meanSquare(errors) / expected == Approx(1).margin(0.05));
}

TEST_CASE("a gear's deflection is not seen by its encoder") {
  // Proves that stiction adds its full variance to the difference between joint and encoder.
  SimulationPlan plan = handMadePlan(v6(), 80);
  plan.mechanics.poseScatter = radians(0.1);
  const double rounding = step * step / 12 + std::pow(plan.mechanics.encoderDither, 2);
  CHECK(meanSquare(encoderErrors(plan)) / (rounding + std::pow(radians(0.1), 2)) == Approx(1).margin(0.1));
}

TEST_CASE("load holds a gear's play where it overcomes the gap's friction, the last motion elsewhere") {
  // Proves the side of the gap in every pose from the robot's true torques, and that both regimes occur.
  SimulationPlan plan = handMadePlan(v6(), 40);
  plan.mechanics.encoderDither = 0;
  const auto joint = static_cast<Eigen::Index>(*v6().jointIndex("LHipPitch"));
  const Simulation sound = simulate(v6(), plan, 1);
  plan.flaw = "gearPlay@LHipPitch";
  const Simulation loose = simulate(v6(), plan, 1);
  RandomStream nothing{1, "nothing"};
  const SyntheticRobot drawn{v6(), drawErrors(v6(), 0, 0, 0, nothing), {}};
  int byLoad = 0, byMotion = 0;
  for (std::size_t i = 0; i < loose.set.captures.size(); ++i) {
    const double torque = drawn.gravityTorques(sound.exposures[i].joints, SupportFoot::left)[joint];
    const double side = 2 * (loose.exposures[i].joints[joint] - sound.exposures[i].joints[joint]) / radians(0.7);
    const double approach = loose.set.captures[i].joints.approach[static_cast<std::size_t>(joint)];
    REQUIRE(std::abs(std::abs(side) - 1) < 1e-9);
    if (std::abs(torque) > 0.3) {
      CHECK(side * torque > 0);
      byLoad += side == Approx(approach);
    } else {
      CHECK(side == Approx(-approach));
      byMotion += side * torque < 0;
    }
  }
  CHECK(byLoad > 0);
  CHECK(byMotion > 0);
}

TEST_CASE("at rest few readings change, after coming back to a pose most do") {
  // Proves that rounding errors persist at rest (only where dither crosses a step's edge they change: about 13 %) and
  // are drawn anew for each approach. 12 poses, 2 cameras, 2 changes, 24 joints: 1152 readings.
  SimulationPlan plan = handMadePlan(v6(), 12);
  plan.repeatKind = RepeatKind::rest;
  const int atRest = changedReadings(plan);
  plan.repeatKind = RepeatKind::reapproach;
  const int comingBack = changedReadings(plan);
  CHECK(atRest > 0);
  CHECK(atRest < 0.2 * 1152);
  CHECK(comingBack > 0.6 * 1152);
}

TEST_CASE("stiction of a pose is the same in all its samples, stiction of an approach is not") {
  // Proves which samples share each kind of scatter, by the spread of the true angles over a pose's samples with
  // exactly repeating motors.
  SimulationPlan plan = handMadePlan(v6(), 6);
  plan.repeatKind = RepeatKind::reapproach;
  plan.mechanics.servoDeadZone = plan.mechanics.residualSpeed = 0;
  const auto spread = [&] {
    const Simulation simulation = simulate(v6(), plan, 1);
    return (simulation.exposures[0].joints - simulation.exposures[2].joints).norm();
  };
  plan.mechanics.poseScatter = 1e-3;
  CHECK(spread() == 0);
  plan.mechanics.approachScatter = 1e-3;
  CHECK(spread() > 1e-3);
}

TEST_CASE("the one motor of both hip yaw-pitch joints has one reading, one command and one offset") {
  // Proves that both names always agree, even if the pose differs. Two cameras, three samples, with stiction.
  SimulationPlan plan = handMadePlan(v6(), 4);
  plan.mechanics.poseScatter = plan.mechanics.approachScatter = 1e-3;
  const std::size_t left = *v6().jointIndex("LHipYawPitch"), right = *v6().jointIndex("RHipYawPitch");
  plan.poses[0].angles[static_cast<Eigen::Index>(right)] += 0.1;
  const Simulation simulation = simulate(v6(), plan, 1);
  for (const Capture& capture : simulation.set.captures) {
    CHECK(capture.joints.measured[left] == capture.joints.measured[right]);
    CHECK(capture.joints.commanded[left] == capture.joints.commanded[right]);
  }
  for (const Exposure& exposure : simulation.exposures) {
    CHECK(exposure.joints[static_cast<Eigen::Index>(left)] == exposure.joints[static_cast<Eigen::Index>(right)]);
  }
  CHECK(simulation.truth.value("jointOffset", "LHipYawPitch", "o"));
  CHECK_FALSE(simulation.truth.value("jointOffset", "RHipYawPitch", "o"));
}
