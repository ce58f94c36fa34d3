#include "hardware/simulated/SimulatedWorld.hpp"

#include "RobotV6.hpp"
#include "detect/BoardDetector.hpp"
#include "simulation/StandingPoses.hpp"

#include <catch2/catch.hpp>
#include <thread>

using namespace naocal;
using namespace std::chrono_literals;

namespace {

SimulatedPlan quick(std::uint64_t seed = 1) {
  SimulatedPlan plan;
  plan.seed = seed;
  plan.pace = Pace::quick;
  plan.playRange = radians(0.5);
  return plan;
}

RobotCommand holding(const RawAngles& angles) {
  RobotCommand command;
  command.angles = angles;
  command.stiffness.fill(1);
  return command;
}

RobotState after(RobotInterface& robot, int cycles, const RobotCommand& command) {
  RobotState state;
  for (int i = 0; i < cycles; ++i) {
    state = *robot.waitForState(1s);
    robot.send(command);
  }
  return state;
}

RawAngles raw(const Eigen::VectorXd& angles) {
  RawAngles result;
  for (std::size_t joint = 0; joint < v6().joints.size(); ++joint) {
    result[*jointIndex(v6().joints[joint].name)] = angles[Eigen::Index(joint)];
  }
  return result;
}

std::size_t of(const char* joint) {
  return *v6().jointIndex(joint);
}

} // namespace

// Proves the encoder model: motor angle + offset, in steps of 1/4096 turn; the joint itself differs by the gear's play.
TEST_CASE("a simulated robot goes where it is told but for its offsets, and its encoders do not know of them") {
  SimulatedWorld world{v6(), quick()};
  const auto robot = world.robot();
  RawAngles target = SimulatedPlan::standingAngles();
  target[*jointIndex("HeadYaw")] = 0.4;
  target[*jointIndex("LElbowRoll")] = -0.5;
  const RobotState state = after(*robot, 100, holding(target));
  const auto truth = world.truth();
  const double encoderStep = 2 * std::numbers::pi / 4096;
  for (const char* name : {"HeadYaw", "LElbowRoll", "LKneePitch", "RHipYawPitch"}) {
    const std::size_t joint = of(name);
    const double shown = state.angles[*jointIndex(name)];
    const double offset = world.errors().robot.jointOffsets[Eigen::Index(joint)];
    CHECK(std::abs(shown / encoderStep - std::round(shown / encoderStep)) < 1e-9);
    CHECK(std::abs(shown - target[*jointIndex(name)]) < radians(0.6)); // friction, droop and dither
    CHECK(std::abs(truth.joints[Eigen::Index(joint)] + offset - shown) <=
          world.errors().play[joint] / 2 + encoderStep / 2 + 5 * radians(0.007));
  }
  CHECK(state.time == truth.time);
  CHECK(robot->waitForIdentity(0ms)->bodyId == "synthetic-1");
}

// Proves that simulation and poses/ agree on stable poses for robots with unknown offsets, and that the measured forces
// add up to the robot's weight.
TEST_CASE("robots with unknown offsets stand in poses that were planned for them") {
  const auto poses = planStandingPoses(v6(), SimulationPlan{}, SupportFoot::right, 4, 1);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    for (const CommandedPose& pose : poses) {
      SimulatedPlan plan = quick(seed);
      plan.start = raw(pose.angles);
      SimulatedWorld world{v6(), plan};
      const RobotState state = after(*world.robot(), 50, holding(plan.start));
      CHECK(!world.truth().fallen);
      CHECK(world.truth().supportFoot == SupportFoot::right);
      double weight = 0;
      for (const double force : state.forces) {
        weight += force;
      }
      CHECK(weight == Approx(5.36).margin(0.8)); // sensors cannot measure pulling forces, so edges read more
    }
  }
}

// Proves that a robot falls when its centre of mass leaves the sole, that its sensors show it, and that it does not get
// up.
TEST_CASE("a simulated robot falls over when its pose is not stable") {
  SimulatedPlan plan = quick();
  plan.offsetRange = 0;
  SimulatedWorld world{v6(), plan};
  const auto robot = world.robot();
  after(*robot, 50, holding(plan.start));
  CHECK(!world.truth().fallen);
  RawAngles leaning = plan.start;
  leaning[*jointIndex("LAnklePitch")] = leaning[*jointIndex("RAnklePitch")] = radians(25);
  const RobotState state = after(*robot, 200, holding(leaning));
  CHECK(world.truth().fallen);
  CHECK(state.torsoAngles.norm() > 1);
  CHECK(state.accelerometer.z() < 5);
  after(*robot, 200, holding(plan.start));
  CHECK(world.truth().fallen);
}

// Proves that a robot whose eyes have the hold colour is held in an unstable pose, with its lower sole flat on the
// floor, and falls when released unless it is stable then.
TEST_CASE("a simulated robot is held as long as its eyes are yellow") {
  SimulatedPlan plan = quick();
  plan.offsetRange = 0;
  const SyntheticBody body{v6()};
  for (const bool comesBack : {true, false}) {
    SimulatedWorld world{v6(), plan};
    const auto robot = world.robot();
    RobotCommand command = holding(plan.start);
    command.leds.leftEye.fill(holdMeColour);
    after(*robot, 50, command);
    RawAngles leaning = plan.start;
    leaning[*jointIndex("LAnklePitch")] = leaning[*jointIndex("RAnklePitch")] = radians(25);
    command.angles = leaning;
    after(*robot, 200, command);
    CHECK(!world.truth().fallen);
    const auto truth = world.truth();
    const Eigen::Isometry3d sole =
        truth.worldFromTorso * body.forwardKinematics(truth.joints)[v6().findSole("left")->link];
    CHECK(sole.linear().col(2).z() > 1 - 1e-6);
    CHECK(std::abs(sole.translation().z()) < 0.01);
    if (comesBack) {
      command.angles = plan.start;
      after(*robot, 100, command);
    }
    command.leds = {};
    after(*robot, 200, command);
    CHECK(world.truth().fallen == !comesBack);
  }
}

// Proves that the supporting sole does not slide.
TEST_CASE("the support foot stays where it is while the rest of the robot moves") {
  SimulatedPlan plan = quick(3);
  plan.start = raw(planStandingPoses(v6(), SimulationPlan{}, SupportFoot::left, 1, 2).front().angles);
  SimulatedWorld world{v6(), plan};
  const auto robot = world.robot();
  const SyntheticBody body{v6()};
  const auto sole = [&] {
    const auto truth = world.truth();
    return truth.worldFromTorso * body.forwardKinematics(truth.joints)[v6().findSole("left")->link];
  };
  after(*robot, 20, holding(plan.start));
  const Eigen::Isometry3d before = sole();
  RawAngles turned = plan.start;
  turned[*jointIndex("HeadYaw")] += 0.3;
  turned[*jointIndex("LKneePitch")] += 0.02;
  turned[*jointIndex("LAnklePitch")] -= 0.02;
  for (int i = 0; i < 50; ++i) {
    after(*robot, 1, holding(turned));
    CHECK(sole().isApprox(before, 1e-6));
  }
  CHECK(before.translation().y() == Approx(halfFootDistance));
}

// Proves that motors heat up under load.
TEST_CASE("a motor that carries gets warmer than one that does not") {
  SimulatedPlan plan = quick();
  plan.mechanics.thermalTimeConstant = 5;
  plan.mechanics.heatPerTorqueSquared = 20;
  SimulatedWorld world{v6(), plan};
  const RobotState state = after(*world.robot(), 1000, holding(plan.start));
  CHECK(state.temperature[*jointIndex("LKneePitch")] > state.temperature[*jointIndex("HeadYaw")] + 1);
  CHECK(state.temperature[*jointIndex("HeadYaw")] < plan.mechanics.ambientTemperature + 3);
}
