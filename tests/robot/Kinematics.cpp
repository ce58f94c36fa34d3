#include "robot/Kinematics.hpp"
#include "RobotV6.hpp"
#include "io/Files.hpp"
#include "math/Angles.hpp"

#include "TemporaryFolder.hpp"

#include <catch2/catch.hpp>

using namespace naocal;

namespace {

/// Forward kinematics with all angles zero except the given ones [degrees].
LinkPoses postureAt(const Robot& robot, const std::vector<std::pair<std::string, double>>& angles) {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.joints.size()));
  for (const auto& [joint, angle] : angles) {
    all[static_cast<Eigen::Index>(*robot.jointIndex(joint))] = radians(angle);
  }
  return forwardKinematics(robot, all);
}

void checkPoint(const Eigen::Vector3d& found, const Eigen::Vector3d& expected) {
  CAPTURE(found.transpose(), expected.transpose());
  CHECK((found - expected).norm() < 1e-12);
}

} // namespace

TEST_CASE("the zero pose has the heights of the drawing's sums") {
  // Proves lengths and signs for the straight robot: 85 + 100 + 102.9 + 45.19 = 333.09 mm from torso to sole; + 126.5 +
  // 63.64 = 523.23 mm to the top camera; arms horizontal, forward.
  const Robot robot = v6();
  const LinkPoses torsoFromLink = postureAt(robot, {});
  for (const RigidTransform& link : torsoFromLink) {
    CHECK(link.rotation == Eigen::Matrix3d::Identity());
  }
  checkPoint(torsoFromLink[*robot.linkIndex("LSole")].translation, {0, 0.05, -0.33309});
  checkPoint(torsoFromLink[*robot.linkIndex("RSole")].translation, {0, -0.05, -0.33309});
  checkPoint(torsoFromLink[*robot.linkIndex("LWrist")].translation, {0.16095, 0.113, 0.1});
  checkPoint(torsoFromLink[*robot.linkIndex("RWrist")].translation, {0.16095, -0.113, 0.1});
  const CameraMount& top = robot.cameras[*robot.cameraIndex("top")];
  checkPoint(torsoFromLink[top.link] * top.translation - torsoFromLink[*robot.linkIndex("LSole")].translation,
             {0.05871, -0.05, 0.52323});
}

TEST_CASE("a right angle at one joint puts the links beyond it where geometry says") {
  // Proves axis and sign of every kind of joint by cases that can be verified on paper (right-handed about x forward, y
  // left, z up; positive pitch bends forward).
  const Robot robot = v6();
  const auto origin = [&](const char* link, const std::vector<std::pair<std::string, double>>& angles) {
    return postureAt(robot, angles)[*robot.linkIndex(link)].translation;
  };
  checkPoint(origin("LWrist", {{"LShoulderPitch", 90}}), {0, 0.113, 0.1 - 0.16095});
  checkPoint(origin("RWrist", {{"RShoulderPitch", 90}}), {0, -0.113, 0.1 - 0.16095});
  checkPoint(origin("LWrist", {{"LShoulderRoll", 90}}), {-0.015, 0.098 + 0.16095, 0.1});
  checkPoint(origin("LWrist", {{"LElbowRoll", -90}}), {0.105, 0.113 - 0.05595, 0.1});
  checkPoint(origin("LWrist", {{"LElbowYaw", 90}, {"LElbowRoll", -90}}), {0.105, 0.113, 0.1 - 0.05595});
  checkPoint(origin("LSole", {{"LKneePitch", 90}}), {-0.14809, 0.05, -0.185});
  checkPoint(origin("LSole", {{"LHipPitch", -90}}), {0.24809, 0.05, -0.085});
  checkPoint(origin("LSole", {{"LAnklePitch", 90}}), {-0.04519, 0.05, -0.2879});
  checkPoint(origin("LSole", {{"LHipRoll", 90}}), {0, 0.05 + 0.24809, -0.085});
  checkPoint(origin("RSole", {{"RHipRoll", -90}}), {0, -0.05 - 0.24809, -0.085});
  checkPoint(origin("RSole", {{"RAnkleRoll", -90}}), {0, -0.05 - 0.04519, -0.2879});
  // A half turn about (0, 1, -1)/sqrt2 maps -z to y; about (0, 1, 1)/sqrt2 it maps -z to -y.
  checkPoint(origin("LSole", {{"LHipYawPitch", 180}}), {0, 0.05 + 0.24809, -0.085});
  checkPoint(origin("RSole", {{"RHipYawPitch", 180}}), {0, -0.05 - 0.24809, -0.085});
}

TEST_CASE("both feet turn outwards for negative hip yaw-pitch") {
  // Proves the sign of the shared motor; source: descriptions of HULKs and the manufacturer.
  const Robot robot = v6();
  const LinkPoses torsoFromLink = postureAt(robot, {{"LHipYawPitch", -30}, {"RHipYawPitch", -30}});
  CHECK(torsoFromLink[*robot.linkIndex("LSole")].rotation(1, 0) > 0.1);
  CHECK(torsoFromLink[*robot.linkIndex("RSole")].rotation(1, 0) < -0.1);
}

TEST_CASE("a robot that is no NAO runs through the same code") {
  // Proves that the kinematics depends on no name of a NAO: an invented arm with one joint, one length and one camera,
  // whose image axes are derived by hand.
  const TemporaryFolder folder;
  writeAtomically(folder.path() / "crane.json", R"({
    "format": "naocal-drawing", "version": 1, "model": "crane",
    "lengthsMillimetres": {"mast": 2000},
    "tree": {"links": [
      {"name": "Base"},
      {"name": "Jib", "parent": "Base", "joint": "slew", "originMillimetres": [100, 0, 0],
       "alongLengths": {"mast": [0, 0, 1]}}]},
    "joints": {"slew": {"axis": [0, 0, 0.5], "limitsDegrees": [-90, 90], "maxSpeedDegreesPerSecond": 10}},
    "cameras": {"tip": {"link": "Jib", "originMillimetres": [500, 0, 0], "pitchDegrees": 90}}})");
  const Robot crane = loadRobot(folder.path() / "crane.json");
  ModelState modelState = nominalState(crane, StateLayout{1, 1, 0});
  modelState.angle(0) = radians(90);
  modelState.length(0) = 2.5; // stretched
  const LinkPoses baseFromLink = forwardKinematics(crane, modelState);
  const RigidTransform baseFromOptical = baseFromLink[1] * linkFromOptical(crane.cameras[0], modelState);
  checkPoint(baseFromOptical.translation, {0.1, 0.5, 2.5});
  checkPoint(baseFromOptical.rotation.col(2), {0, 0, -1}); // looks down;
  checkPoint(baseFromOptical.rotation.col(0), {1, 0, 0});  // image right = forward of the base
}
