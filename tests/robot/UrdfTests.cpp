#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"
#include "robot/Gravity.hpp"
#include "robot/Urdf.hpp"

#include "SharedData.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

using namespace naocal;
using nlohmann::json;

namespace {

/// An arm with a turning base, a rotated shoulder, a slide, a wheel without limits, and a gripper that follows the
/// slide.
const std::string arm = R"(<robot name="arm">
  <link name="base"><inertial><origin xyz="0.1 0 0.05"/><mass value="2"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <link name="upper"><inertial><origin xyz="0 0.02 0.2"/><mass value="1.5"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <link name="slider"><inertial><origin xyz="0.05 0 0"/><mass value="0.7"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <link name="wheel"><inertial><origin xyz="0.03 0.01 0"/><mass value="0.2"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <link name="finger"><inertial><origin xyz="0 0 0.04"/><mass value="0.1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <link name="plate"/>
  <joint name="turn" type="revolute"><parent link="base"/><child link="upper"/><origin xyz="0 0 0.3" rpy="0.4 -0.2 1.1"/><axis xyz="0 0.6 0.8"/><limit lower="-2" upper="1.5" velocity="3" effort="1"/></joint>
  <joint name="slide" type="prismatic"><parent link="upper"/><child link="slider"/><origin xyz="0.1 0 0.4" rpy="0 1.2 0"/><axis xyz="1 0 0"/><limit lower="0" upper="0.3" velocity="1" effort="1"/></joint>
  <joint name="roll" type="continuous"><parent link="slider"/><child link="wheel"/><origin xyz="0.2 0 0" rpy="0 0 -0.7"/></joint>
  <joint name="grip" type="revolute"><parent link="wheel"/><child link="finger"/><origin xyz="0 0.05 0.02"/><axis xyz="0 0 2"/><limit lower="-1" upper="1" velocity="1" effort="1"/><mimic joint="roll" multiplier="-0.5" offset="0.1"/></joint>
  <joint name="mount" type="fixed"><parent link="finger"/><child link="plate"/><origin xyz="0 0 0.1" rpy="1.5 0 0"/></joint>
</robot>)";

ModelState stateAt(const Robot& robot, const Eigen::VectorXd& angles) {
  ModelState state = nominalState(robot, StateLayout{robot.joints.size(), 0, 0});
  state.values.head(angles.size()) = angles;
  return state;
}

/// The text with one part replaced.
std::string with(std::string text, const std::string& part, const std::string& replacement) {
  const std::size_t at = text.find(part);
  REQUIRE(at != text.npos);
  return text.replace(at, part.size(), replacement);
}

} // namespace

TEST_CASE("a URDF's links, joints, limits and mimicked joints are read") {
  // Proves names, kinds, limits, defaults (axis x, no inertial: no mass) and the relation of a joint that mimics.
  const Robot robot = parseUrdf(arm, "arm.urdf");
  CHECK(robot.model == "arm");
  REQUIRE(robot.links.size() == 6);
  REQUIRE(robot.joints.size() == 4);
  const Joint &turn = robot.joints[0], &slide = robot.joints[1], &roll = robot.joints[2], &grip = robot.joints[3];
  CHECK(turn.limits.lower == -2);
  CHECK(turn.limits.upper == 1.5);
  CHECK(turn.maxSpeed == 3);
  CHECK(turn.axis.isApprox(Eigen::Vector3d{0, 0.6, 0.8}));
  CHECK(slide.isPrismatic);
  CHECK_FALSE(turn.isPrismatic);
  CHECK(roll.axis == Eigen::Vector3d::UnitX());
  CHECK(std::isinf(roll.limits.upper));
  CHECK(grip.motor == 2);
  CHECK(grip.ratio == -0.5);
  CHECK(grip.shift == 0.1);
  CHECK(grip.axis == Eigen::Vector3d::UnitZ());
  CHECK(robot.links[*robot.linkIndex("plate")].mass == 0);
  CHECK_FALSE(robot.links[*robot.linkIndex("plate")].joint);
}

TEST_CASE("a URDF's kinematics follow its specification") {
  // Proves the order of a joint's origin, its rotation about fixed axes and its own motion, against Eigen's transforms.
  const Robot robot = parseUrdf(arm, "arm.urdf");
  const Eigen::Vector4d q{0.7, 0.12, -1.9, 0.35};
  const auto step = [](const Eigen::Vector3d& xyz, const Eigen::Vector3d& rpy) {
    return Eigen::Isometry3d{Eigen::Translation3d{xyz} * Eigen::AngleAxisd{rpy[2], Eigen::Vector3d::UnitZ()} *
                             Eigen::AngleAxisd{rpy[1], Eigen::Vector3d::UnitY()} *
                             Eigen::AngleAxisd{rpy[0], Eigen::Vector3d::UnitX()}};
  };
  const Eigen::Isometry3d expected =
      step({0, 0, 0.3}, {0.4, -0.2, 1.1}) * Eigen::AngleAxisd{q[0], Eigen::Vector3d{0, 0.6, 0.8}} *
      step({0.1, 0, 0.4}, {0, 1.2, 0}) * Eigen::Translation3d{q[1], 0, 0} * step({0.2, 0, 0}, {0, 0, -0.7}) *
      Eigen::AngleAxisd{q[2], Eigen::Vector3d::UnitX()} * step({0, 0.05, 0.02}, {0, 0, 0}) *
      Eigen::AngleAxisd{q[3], Eigen::Vector3d::UnitZ()} * step({0, 0, 0.1}, {1.5, 0, 0});
  const RigidTransform plate = forwardKinematics(robot, q)[*robot.linkIndex("plate")];
  CHECK((plate.rotation - expected.rotation()).norm() < 1e-14);
  CHECK((plate.translation - expected.translation()).norm() < 1e-14);
}

TEST_CASE("gravity's load on slides and mimicking joints is the slope of the potential") {
  // Proves torques, their derivatives, and what a motor bears through a joint that mimics at another ratio, against
  // central differences, with the base, the slider or the tip held still.
  const Robot robot = parseUrdf(arm, "arm.urdf");
  std::mt19937 random{3};
  std::normal_distribution<double> normal;
  for (const char* held : {"base", "slider", "finger"}) {
    const std::size_t heldLink = *robot.linkIndex(held);
    const Eigen::Vector3d upInHeld = Eigen::Vector3d{normal(random), normal(random), normal(random)}.normalized();
    const auto load = [&](const Eigen::VectorXd& q) {
      const ModelState state = stateAt(robot, q);
      const LinkPoses poses = forwardKinematics(robot, state);
      return gravityLoad(robot, state, poses, heldLink, poses[heldLink].rotation * upInHeld, true);
    };
    const auto potential = [&](const Eigen::VectorXd& q) {
      const LinkPoses poses = forwardKinematics(robot, stateAt(robot, q));
      const CentreOfMass centre = centreOfMass(robot, poses);
      return gravity * centre.mass * upInHeld.dot(poses[heldLink].inverse() * centre.inTorso);
    };
    Eigen::VectorXd q{{0.7, 0.12, -1.9, 0.35}};
    const GravityLoad at = load(q);
    for (Eigen::Index joint = 0; joint < 4; ++joint) {
      CAPTURE(held, robot.joints[joint].name);
      const Joint& drawn = robot.joints[static_cast<std::size_t>(joint)];
      constexpr double step = 1e-5;
      const auto moved = [&](double by) { // all joints of the motor
        Eigen::VectorXd result = q;
        for (Eigen::Index other = 0; other < 4; ++other) {
          const Joint& one = robot.joints[static_cast<std::size_t>(other)];
          result[other] += one.motor == drawn.motor ? by * one.ratio : 0;
        }
        return result;
      };
      CHECK(at.torque[joint] == Approx(-(potential(moved(step)) - potential(moved(-step))) / (2 * step)).margin(1e-8));
      const auto motor = static_cast<Eigen::Index>(drawn.motor);
      CHECK(at.torqueGrowth[joint] ==
            Approx((load(moved(step)).torque[motor] - load(moved(-step)).torque[motor]) / (2 * step)).margin(1e-7));
      Eigen::VectorXd more = q, less = q;
      more[joint] += step;
      less[joint] -= step;
      const GravityLoad above = load(more), below = load(less);
      CHECK((at.torqueByAngle.col(joint) - (above.torque - below.torque) / (2 * step)).norm() < 1e-7);
      CHECK((at.growthByAngle.col(joint) - (above.torqueGrowth - below.torqueGrowth) / (2 * step)).norm() < 1e-7);
      CHECK((at.comByAngle.col(joint) - (above.com - below.com) / (2 * step)).norm() < 1e-8);
    }
  }
}

TEST_CASE("what is no URDF of a robot is refused in one sentence with its place") {
  // Proves one sentence per kind of bad input; that nothing worse happens for other bytes is the fuzzer's to find.
  struct Row {
    const char *part, *replacement, *sentence;
  };
  const auto [part, replacement, sentence] = GENERATE(values<Row>({
      {"<robot name=\"arm\">", "<robot name=\"arm\"><link name=\"base\"/>",
       "link 'base': expected a name that no link before has"},
      {"type=\"continuous\"", "type=\"spherical\"",
       "joint 'roll': expected a type among revolute, continuous, prismatic, fixed, found 'spherical'"},
      {"type=\"continuous\"", "type=\"floating\"", "found 'floating'"},
      {"<link name=\"plate\"/>", "<link name=\"plate\"/><link name=\"lonely\"/>",
       "expected one root, a link that is no joint's child, found 2: base, lonely"},
      {"<parent link=\"base\"/>", "<parent link=\"plate\"/>", "form a loop"},
      {"<child link=\"plate\"/>", "<child link=\"upper\"/>", "the links form a loop"},
      {"<child link=\"plate\"/>", "<child link=\"base\"/>", "links that form a loop"},
      {"<child link=\"plate\"/>", "<child link=\"plait\"/>",
       "joint 'mount': expected a <child> with the name of a link, found 'plait'"},
      {"<parent link=\"finger\"/>", "", "joint 'mount': expected a <parent> with the name of a link, found none"},
      {"ixx=\"1\"", "ixx=\"nan\"",
       "<inertia> of <inertial> of link 'base': expected finite numbers in 'ixx', found 'nan'"},
      {"<mass value=\"2\"/>", "<mass value=\"-2\"/>", "link 'base': expected a mass of at least 0 kg, found -2"},
      {"<mass value=\"2\"/>", "<mass value=\"heavy\"/>", "found 'heavy'"},
      {"<axis xyz=\"1 0 0\"/>", "<axis xyz=\"0 0 0\"/>",
       "joint 'slide': expected an axis with a direction, found 0 0 0"},
      {"<axis xyz=\"1 0 0\"/>", "<axis xyz=\"1 0\"/>", "expected 3 numbers in 'xyz', found '1 0'"},
      {"lower=\"-2\" upper=\"1.5\"", "lower=\"2\" upper=\"1.5\"",
       "joint 'turn': expected a lower limit not above the upper one, found 2 and 1.5"},
      {"mimic joint=\"roll\"", "mimic joint=\"rol\"",
       "joint 'grip': expected to mimic a joint that moves, found 'rol'"},
      {"mimic joint=\"roll\"", "mimic joint=\"mount\"", "found 'mount'"},
      {"mimic joint=\"roll\"", "mimic joint=\"grip\"", "joints that mimic each other in a circle"},
      {"<robot name=\"arm\">", "<robot name=\"arm\"><xacro:include filename=\"a\"/>",
       "a xacro file, not a URDF; expand it first"},
      {"xyz=\"0 0 0.3\"", "xyz=\"0 0 ${height}\"", "expand it first"},
      {"xyz=\"0 0 0.3\"", "xyz=\"0 0 $(arg height)\"", "expand it first"},
      {"<link name=\"plate\"/>", "<link name=\"pl\xe4te\"/>",
       "arm.urdf, line 7, <link>: expected a name in UTF-8, found \"pl\xef\xbf\xbdte\"; write it in UTF-8"},
      {"joint name=\"roll\"", "joint name=\"r\xf6ll\"", "line 10, <joint>: expected a name in UTF-8"},
      {"joint name=\"mount\"", "joint name=\"m&#246;unt\"", "line 12, <joint>: expected a name in UTF-8"},
      {"<robot name=\"arm\">", "<robot name=\"\xc3\">", "line 1, <robot>: expected a name in UTF-8"},
      {"</robot>", "", "expected XML, found an error there"},
      {"<robot name=\"arm\">", "<model name=\"arm\">", "expected XML, found an error there"},
      {"<limit lower=\"-2\" upper=\"1.5\" velocity=\"3\" effort=\"1\"/>", "",
       "joint 'turn': expected a <limit>, as its type is revolute, found none"},
  }));
  CAPTURE(part, replacement);
  CHECK_THROWS_WITH(parseUrdf(with(arm, part, replacement), "arm.urdf"),
                    Catch::StartsWith("arm.urdf") && Catch::Contains(sentence));
  try {
    parseUrdf(with(arm, part, replacement), "arm.urdf");
  } catch (const InputError& error) {
    CHECK(std::string{error.what()}.find('\n') == std::string::npos);
  }
}

TEST_CASE("a URDF's names are any in UTF-8 and its comments any bytes") {
  // Proves that names of other alphabets are kept, as bytes and as references, and that only names are refused for
  // their bytes.
  const std::string declared = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>";
  const std::string greek = "\xce\xb1"; // alpha
  CHECK(parseUrdf(with(arm, "\"turn\"", '"' + greek + '"'), "a").jointIndex(greek));
  CHECK(parseUrdf(declared + with(arm, "\"turn\"", "\"&#945;\""), "a").jointIndex(greek));
  CHECK_NOTHROW(parseUrdf(with(arm, "<link name=\"plate\"/>", "<!-- \xe4 --><link name=\"plate\"/>"), "a"));
}

TEST_CASE("comments of a URDF do not count, and deep nesting does not exhaust the stack") {
  // Proves that expressions and elements within comments are ignored, and the limits of nesting and links.
  CHECK_NOTHROW(
      parseUrdf(with(arm, "<link name=\"plate\"/>", "<!-- ${x} <xacro:y> <a> --><link name=\"plate\"/>"), "a"));
  std::string deep;
  for (int i = 0; i < 1000000; ++i) {
    deep += "<a>";
  }
  CHECK_THROWS_WITH(parseUrdf(with(arm, "<link name=\"plate\"/>", deep), "a"), Catch::Contains("within each other"));
  std::string many = "<robot name=\"r\">";
  for (int i = 0; i < 1001; ++i) {
    many += "<link name=\"l" + std::to_string(i) + "\"/>";
  }
  CHECK_THROWS_WITH(parseUrdf(many + "</robot>", "a"), Catch::Contains("1 to 1000 links, found 1001"));
}

TEST_CASE("kinematics, masses and torques of other robots agree with independent ones to 1e-9") {
  // Proves them for K1, SO-101 and UR10 in several poses, with the base and a foot held still; also the torques that
  // bearings bear.
  const auto file = sharedData("conformance-robots/kinematics.json");
  if (!file) {
    return;
  }
  const json conformance = json::parse(readFile(*file));
  const std::map<std::string, std::string> urdfs{
      {"k1", "robots/k1.urdf"}, {"so101", "robots/so101.urdf"}, {"ur10", "robots/ur10-laas/robot.urdf"}};
  for (const auto& urdf : urdfs) { // name, file
    const Robot robot = loadUrdf(*sharedData(urdf.second));
    for (const json& pose : conformance[urdf.first]) {
      Eigen::VectorXd q = Eigen::VectorXd::Zero(eigenIndex(robot.joints.size()));
      for (const auto& [joint, angle] : pose["joints"].items()) {
        q[eigenIndex(*robot.jointIndex(joint))] = angle;
      }
      const ModelState state = stateAt(robot, q);
      const LinkPoses poses = forwardKinematics(robot, state);
      for (const auto& [link, rows] : pose["links"].items()) {
        const RigidTransform& ours = poses[*robot.linkIndex(link)];
        for (int row = 0; row < 3; ++row) {
          for (int column = 0; column < 3; ++column) {
            CHECK(std::abs(ours.rotation(row, column) - rows[row][column].get<double>()) < 1e-9);
          }
          CHECK(std::abs(ours.translation[row] - rows[row][3].get<double>()) < 1e-9);
        }
      }
      const CentreOfMass centre = centreOfMass(robot, poses);
      CHECK(std::abs(centre.mass - pose["mass"].get<double>()) < 1e-9);
      for (int row = 0; row < 3; ++row) {
        CHECK(std::abs(centre.inTorso[row] - pose["centreOfMass"][row].get<double>()) < 1e-9);
      }
      const auto checkTorques = [&](const json& expected, std::size_t held) {
        const Eigen::Vector3d up = poses[held].rotation.col(2);
        const Eigen::VectorXd torques = gravityTorques(robot, state, poses, held, up);
        const Eigen::Matrix2Xd lateral = lateralTorques(robot, state, poses, held, up);
        for (const auto& [joint, torque] : expected["torque"].items()) {
          const Eigen::Index index = eigenIndex(*robot.jointIndex(joint));
          CAPTURE(urdf.first, joint, held);
          CHECK(std::abs(torques[index] - torque.get<double>()) < 1e-9);
          for (int normal = 0; normal < 2; ++normal) {
            CHECK(std::abs(lateral(normal, index) - expected["lateral"][joint][normal].get<double>()) < 1e-9);
          }
        }
      };
      checkTorques(pose, 0);
      if (pose.contains("held")) {
        checkTorques(pose["held"], *robot.linkIndex(pose["held"]["link"].get<std::string>()));
      }
    }
  }
}
