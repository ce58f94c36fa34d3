#include "dialects/UrdfCorrection.hpp"

#include "io/InputError.hpp"
#include "robot/Kinematics.hpp"
#include "robot/Urdf.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <random>
#include <yaml-cpp/yaml.h>

using namespace naocal;

namespace {

/// An arm with a rotated, a bare, a sliding, an endless and a mimicking joint; a comment and a mesh that must stay.
const std::string arm = R"(<?xml version="1.0" ?>
<robot name="arm">
  <!-- drawn by hand -->
  <link name="base"><visual><geometry><mesh filename="package://arm/base.stl"/></geometry></visual></link>
  <link name="a"/><link name="b"/><link name="c"/><link name="d"/><link name="e"/>
  <joint name="turn" type="revolute"><parent link="base"/><child link="a"/><origin xyz="0 0 0.3" rpy="0.4 -0.2 1.1"/><axis xyz="0 0.6 0.8"/><limit lower="-2" upper="2" velocity="3" effort="1"/></joint>
  <joint name="bare" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 1 0"/><limit lower="-2" upper="2" velocity="3" effort="1"/></joint>
  <joint name="slide" type="prismatic"><parent link="b"/><child link="c"/><origin xyz="0.1 0 0.4" rpy="0 1.5707963267948966 0.3"/><axis xyz="1 0 0"/><limit lower="-1" upper="1" velocity="1" effort="1"/></joint>
  <joint name="roll" type="continuous"><parent link="c"/><child link="d"/><origin xyz="0.2 0 0" rpy="0 0 -0.7"/></joint>
  <joint name="grip" type="revolute"><parent link="d"/><child link="e"/><origin xyz="0 0.05 0.02"/><axis xyz="0 0 1"/><limit lower="-9" upper="9" velocity="1" effort="1"/><mimic joint="roll" multiplier="-0.5" offset="0.1"/></joint>
</robot>)";

std::vector<Eigen::Isometry3d> poses(const Robot& robot, const std::vector<double>& angles) {
  Eigen::VectorXd q{static_cast<Eigen::Index>(robot.joints.size())};
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const Joint& joint = robot.joints[i];
    q[static_cast<Eigen::Index>(i)] = joint.motor == i ? angles[i] : joint.ratio * angles[joint.motor] + joint.shift;
  }
  ModelState state = nominalState(robot, StateLayout{robot.joints.size(), 0, 0});
  state.values.head(q.size()) = q;
  std::vector<Eigen::Isometry3d> result;
  for (const RigidTransform& pose : forwardKinematics(robot, state)) {
    result.push_back(Eigen::Translation3d{pose.translation} * Eigen::Quaterniond{pose.rotation});
  }
  return result;
}

} // namespace

TEST_CASE("a corrected URDF has at the readings the poses that the old one has at the true angles") {
  // Proves origins, offsets of all kinds of joints, and that a joint that mimics follows; geometry apart (below).
  const Robot old = parseUrdf(arm, "arm.urdf");
  std::map<std::string, UrdfJointCorrection> corrections;
  const std::vector<double> offsets{0.05, -0.03, 0.004, 0.02, 0};
  for (std::size_t i = 0; i + 1 < old.joints.size(); ++i) {
    corrections[old.joints[i].name].offset = offsets[i];
  }
  const std::string text = correctUrdf(arm, "arm.urdf", old, corrections);
  CHECK(text.find("<!-- drawn by hand -->") != std::string::npos);
  CHECK(text.find("package://arm/base.stl") != std::string::npos);
  CHECK(text.find("offset 2.8648 degrees") != std::string::npos);
  CHECK(text.find("offset 4.0000 mm") != std::string::npos);
  const Robot corrected = parseUrdf(text, "corrected.urdf");
  std::mt19937 chance{1};
  std::uniform_real_distribution<double> angle{-1, 1};
  for (int round = 0; round < 20; ++round) {
    std::vector<double> readings(old.joints.size()), truth(old.joints.size());
    for (std::size_t i = 0; i < readings.size(); ++i) {
      readings[i] = angle(chance);
      truth[i] = readings[i] - offsets[i];
    }
    const auto asRead = poses(corrected, readings), asTrue = poses(old, truth);
    for (std::size_t link = 0; link < asRead.size(); ++link) {
      CHECK((asRead[link].matrix() - asTrue[link].matrix()).cwiseAbs().maxCoeff() < 1e-12);
    }
  }
}

TEST_CASE("a corrected URDF has the link geometry in its origins") {
  const Robot old = parseUrdf(arm, "arm.urdf");
  const UrdfJointCorrection correction{0.1, 0, {0.001, -0.002, 0.003}, {0.01, 0.02, -0.03}};
  const Robot corrected = parseUrdf(correctUrdf(arm, "arm.urdf", old, {{"roll", correction}}), "corrected.urdf");
  const std::vector<double> zero(old.joints.size(), 0.0);
  const Robot& robot = corrected;
  const std::size_t link = robot.joints[*robot.jointIndex("roll")].link, parent = *robot.links[link].parent;
  const auto before = poses(old, zero), after = poses(corrected, zero);
  const Eigen::Isometry3d expected =
      before[parent].inverse() * before[link] * Eigen::Translation3d{correction.translation} *
      Eigen::AngleAxisd{0.01, Eigen::Vector3d::UnitX()} * Eigen::AngleAxisd{0.02, Eigen::Vector3d::UnitY()} *
      Eigen::AngleAxisd{-0.03, Eigen::Vector3d::UnitZ()} * Eigen::AngleAxisd{-0.1, Eigen::Vector3d::UnitX()};
  CHECK(((after[parent].inverse() * after[link]).matrix() - expected.matrix()).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("offsets are written as YAML that reads back exactly, and unknown joints are refused") {
  const Robot robot = parseUrdf(arm, "arm.urdf");
  const YAML::Node yaml = YAML::Load(urdfOffsetsYaml(robot, {{"turn", {0.1 / 3, 1e-4, {}, {}}}}));
  CHECK(yaml["joint_offsets"]["turn"]["offset"].as<double>() == 0.1 / 3);
  CHECK(yaml["joint_offsets"]["turn"]["sigma"].as<double>() == 1e-4);
  CHECK_THROWS_WITH(correctUrdf(arm, "arm.urdf", robot, {{"elbow", {}}}), Catch::Contains("the joint elbow"));
}
