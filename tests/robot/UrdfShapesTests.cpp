#include "io/InputError.hpp"
#include "robot/SelfCollision.hpp"
#include "robot/Urdf.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace naocal;

namespace {

/// A chain of four bent links whose last one can be folded back onto the base; `shapes`: of the last one.
std::string foldingArm(const std::string& shapes) {
  const std::string inertial =
      "<inertial><mass value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" "
      "izz=\"1\"/></inertial>";
  std::string text = "<robot name=\"folding\"><link name=\"l0\"><collision><origin xyz=\"0 0 0.1\"/><geometry><box "
                     "size=\"0.1 0.2 0.04\"/></geometry></collision></link>";
  for (int i = 1; i <= 4; ++i) {
    const std::string n = std::to_string(i), before = std::to_string(i - 1);
    text += "<link name=\"l" + n + "\">" + inertial + (i == 4 ? shapes : "") + "</link><joint name=\"j" + n +
            "\" type=\"revolute\"><parent link=\"l" + before + "\"/><child link=\"l" + n +
            "\"/><origin xyz=\"0 0 0.3\"/><axis xyz=\"0 1 0\"/><limit lower=\"-3.2\" upper=\"3.2\" velocity=\"1\" "
            "effort=\"1\"/></joint>";
  }
  return text + "</robot>";
}

double lengthOf(const Capsule& capsule) {
  return (capsule.to - capsule.from).norm() + 2 * capsule.radius;
}

} // namespace

TEST_CASE("a URDF's spheres, cylinders and boxes are capsules of their size") {
  // Proves sizes and places, the turned cylinder's direction, and that meshes and shapes of no size have none.
  const Robot robot = parseUrdf(
      foldingArm("<collision><origin xyz=\"0.1 0 0\"/><geometry><sphere radius=\"0.05\"/></geometry></collision>"
                 "<collision><origin xyz=\"0 0 0.2\" rpy=\"0 1.5707963267948966 0\"/><geometry><cylinder "
                 "radius=\"0.03\" length=\"0.4\"/></geometry></collision>"
                 "<collision><geometry><mesh filename=\"hand.stl\"/></geometry></collision>"
                 "<collision><geometry><box size=\"0 0.1 0.1\"/></geometry></collision>"),
      "arm.urdf");
  const auto& capsules = robot.collisionCapsules;
  REQUIRE(capsules.size() == 5); // three in the box of l0
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(capsules[i].link == 0);
    CHECK(capsules[i].radius == Approx(0.02));
    CHECK(lengthOf(capsules[i]) == Approx(0.2)); // along y, the longest edge
    CHECK(std::abs(capsules[i].from.x()) <= 0.03 + 1e-12);
    CHECK(capsules[i].from.z() == Approx(0.1));
  }
  const Capsule &sphere = capsules[3], &cylinder = capsules[4];
  CHECK(sphere.from == Eigen::Vector3d{0.1, 0, 0});
  CHECK(sphere.to == sphere.from);
  CHECK(sphere.radius == 0.05);
  CHECK(cylinder.link == *robot.linkIndex("l4"));
  CHECK(lengthOf(cylinder) == Approx(0.4));
  CHECK(std::abs(cylinder.from.x()) == Approx(0.17));
  CHECK(cylinder.from.z() == Approx(0.2));
}

TEST_CASE("shapes whose sizes are no numbers are refused") {
  // Proves it for each shape; the URDF library itself crashes at some of them.
  for (const char* const shape : {"<sphere radius=\"x\"/>", "<cylinder radius=\"\" length=\"1\"/>",
                                  "<cylinder radius=\"1\" length=\"1 2\"/>", "<box size=\"1 2\"/>"}) {
    CHECK_THROWS_AS(
        parseUrdf(foldingArm(std::string{"<collision><geometry>"} + shape + "</geometry></collision>"), "a"),
        InputError);
  }
}

TEST_CASE("a URDF robot that is folded onto itself collides") {
  // Proves that the test for collisions takes a URDF's shapes, for one pose that is free and one that is not.
  const Robot robot =
      parseUrdf(foldingArm("<collision><geometry><sphere radius=\"0.05\"/></geometry></collision>"), "arm.urdf");
  const SelfCollision collision{robot};
  CHECK_FALSE(collision.collides(forwardKinematics(robot, Eigen::VectorXd::Zero(4))));
  const double quarter = std::acos(0.0);
  CHECK_FALSE(collision.collides(forwardKinematics(robot, Eigen::Vector4d{0, quarter, quarter, 0}))); // 0.3 m beside
  const double fold = std::acos(0.25 / 0.3); // l4 is where the base's box is
  CHECK(collision.collides(forwardKinematics(robot, Eigen::Vector4d{0, 2 * quarter - fold, 2 * fold, 0})));
}
