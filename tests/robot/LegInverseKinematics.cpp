#include "RobotV6.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"
#include "robot/Kinematics.hpp"
#include "robot/LegKinematics.hpp"

#include <catch2/catch.hpp>
#include <random>

using namespace naocal;

namespace {

RigidTransform torsoFromSole(const Robot& robot, const LegKinematics& leg, const char* side, const LegAngles& angles) {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.joints.size()));
  for (std::size_t i = 0; i < angles.size(); ++i) {
    all[static_cast<Eigen::Index>(leg.joints()[i])] = angles[i];
  }
  return forwardKinematics(robot, all)[robot.findSole(side)->link];
}

/// Angles within the joints' limits, with the knee bent backwards.
LegAngles randomAngles(const Robot& robot, const LegKinematics& leg, std::mt19937& random) {
  LegAngles angles{};
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const AngleRange limits = robot.joints[leg.joints()[i]].limits;
    const double lower = i == 3 ? 0 : limits.lower;
    angles[i] = std::uniform_real_distribution{lower, limits.upper}(random);
  }
  return angles;
}

} // namespace

TEST_CASE("six leg angles reach every pose that the leg can take, and are the ones that made it") {
  // Compares six angles with the forward kinematics on 4000 poses within the joints' limits. Angles are compared to
  // 1e-6 only: near the straight knee they depend on the square root of round-off in distance. Knees bent forwards are
  // never returned and not tested.
  const Robot robot = v6();
  std::mt19937 random{11};
  for (const char* side : {"left", "right"}) {
    const LegKinematics leg{robot, side};
    for (int i = 0; i < 2000; ++i) {
      const LegAngles made = randomAngles(robot, leg, random);
      const RigidTransform wanted = torsoFromSole(robot, leg, side, made);
      const auto found = leg.solveAngles(wanted);
      REQUIRE(found);
      const RigidTransform reached = torsoFromSole(robot, leg, side, *found);
      CHECK((reached.rotation - wanted.rotation).norm() < 1e-9);
      CHECK((reached.translation - wanted.translation).norm() < 1e-9);
      for (std::size_t k = 0; k < made.size(); ++k) {
        CHECK((*found)[k] == Approx(made[k]).margin(1e-6));
      }
    }
  }
}

TEST_CASE("five leg angles reach the sole's place and its upright for any given hip yaw-pitch") {
  // Compares with the forward kinematics on 4000 poses made with one hip yaw-pitch and solved for another one; for the
  // same one, the full orientation is reached.
  const Robot robot = v6();
  std::mt19937 random{12};
  for (const char* side : {"left", "right"}) {
    const LegKinematics leg{robot, side};
    int reached = 0;
    for (int i = 0; i < 2000; ++i) {
      const LegAngles made = randomAngles(robot, leg, random);
      const RigidTransform wanted = torsoFromSole(robot, leg, side, made);
      const auto same = leg.solveAngles(wanted, made[0]);
      REQUIRE(same);
      CHECK((torsoFromSole(robot, leg, side, *same).rotation - wanted.rotation).norm() < 1e-9);
      const double given = randomAngles(robot, leg, random)[0];
      if (const auto found = leg.solveAngles(wanted, given)) {
        ++reached;
        CHECK((*found)[0] == given);
        const RigidTransform there = torsoFromSole(robot, leg, side, *found);
        CHECK((there.translation - wanted.translation).norm() < 1e-9);
        CHECK((there.rotation.col(2) - wanted.rotation.col(2)).norm() < 1e-9);
      }
    }
    CHECK(reached == 2000); // hip yaw-pitch rotates about the hip: reach does not depend on it
  }
}

TEST_CASE("a sole out of the leg's reach has no angles") {
  // Proves both ends of the reach, just inside and just outside: the straight leg, and the ankle as close to the hip as
  // thigh and tibia (2.9 mm difference) permit.
  const Robot robot = v6();
  const LegKinematics leg{robot, "left"};
  const auto at = [](double depth) {
    return RigidTransform{Eigen::Matrix3d::Identity(), {0, 0.05, -0.085 - 0.04519 - depth}};
  };
  for (const auto& [depth, reachable] :
       {std::pair{0.2029, true}, {0.20291, false}, {0.3, false}, {0.00291, true}, {0.00289, false}, {0.0, false}}) {
    CAPTURE(depth);
    CHECK(leg.solveAngles(at(depth)).has_value() == reachable);
    CHECK(leg.solveAngles(at(depth), 0).has_value() == reachable);
  }
}

TEST_CASE("a leg of another build is refused") {
  // Proves it for a missing side, a different axis and a missing joint; other differences are not covered.
  Robot robot = v6();
  CHECK_THROWS_WITH((LegKinematics{robot, "middle"}), Catch::Contains("middle leg: expected a sole of that name"));
  robot.joints[*robot.jointIndex("LKneePitch")].axis = Eigen::Vector3d::UnitX();
  CHECK_THROWS_WITH((LegKinematics{robot, "left"}), Catch::Contains("left leg: expected axes x, y, y, y, x"));
  robot.links[*robot.linkIndex("RTibia")].joint.reset();
  CHECK_THROWS_WITH((LegKinematics{robot, "right"}), Catch::Contains("right leg: expected six joints"));
}
