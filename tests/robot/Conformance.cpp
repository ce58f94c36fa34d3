#include "io/Files.hpp"
#include "robot/Gravity.hpp"

#include "SharedData.hpp"

#include <nlohmann/json.hpp>

using namespace naocal;
using nlohmann::json;

namespace {

RigidTransform transform(const json& rows) {
  RigidTransform result;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      result.rotation(row, column) = rows[row][column];
    }
    result.translation[row] = rows[row][3];
  }
  return result;
}

double distance(const RigidTransform& a, const RigidTransform& b) {
  return (a.rotation - b.rotation).norm() + (a.translation - b.translation).norm();
}

/// The robot with each hanging arm as one mass at a position rounded to a micrometre, as in the simulator.
Robot withLumpedArms(Robot robot) {
  Eigen::VectorXd resting(static_cast<Eigen::Index>(robot.joints.size()));
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    resting[static_cast<Eigen::Index>(joint)] = robot.joints[joint].restAngle;
  }
  const LinkPoses torsoFromLink = forwardKinematics(robot, resting);
  for (const std::string side : {"L", "R"}) {
    double mass = 0;
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (const char* part : {"Shoulder", "Bicep", "Elbow", "Forearm", "Wrist"}) {
      const std::size_t index = *robot.linkIndex(side + part);
      Link& link = robot.links[index];
      mass += link.mass;
      moment += link.mass * (torsoFromLink[index] * link.centreOfMass);
      link.mass = 0;
    }
    const std::size_t shoulder = *robot.linkIndex(side + "Shoulder");
    const Eigen::Vector3d inTorso = (moment / mass * 1e6).array().round() / 1e6;
    robot.links[shoulder].mass = mass;
    robot.links[shoulder].centreOfMass = torsoFromLink[shoulder].inverse() * inTorso;
  }
  return robot;
}

} // namespace

TEST_CASE("transforms, centres of mass and torques agree with an independent simulator to 1e-9") {
  // Proves that frames, signs and the V6 drawing's numbers for legs, head and masses agree with the contract, for
  // twelve random poses on either foot. Sources give two centres of mass for V6's head; the simulator uses that of
  // NaoV6.json, the other one would differ by up to 0.03 Nm. The simulator's arms are one hanging mass each, rounded to
  // a micrometre (worth 3e-6 Nm), which is repeated here. Arm joints are not covered.
  const auto file = sharedData("conformance/kinematics.json");
  if (!file) {
    return;
  }
  const auto configuration = std::filesystem::path{NAOCAL_SOURCE_DIR} / "home/configuration";
  const Robot robot = withLumpedArms(loadRobot(configuration, "V6"));
  const json conformance = json::parse(readFile(*file));
  const auto& poses = conformance["poses"];
  REQUIRE(poses.size() == 12);
  for (const json& pose : poses) {
    ModelState modelState = nominalState(robot, StateLayout{robot.joints.size(), robot.lengths.size(), 0});
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      modelState.angle(joint) = pose["joints"].value(robot.joints[joint].name, robot.joints[joint].restAngle);
    }
    const LinkPoses torsoFromLink = forwardKinematics(robot, modelState);
    const std::size_t sole = robot.findSole(pose["supportFoot"].get<std::string>())->link;
    const RigidTransform soleFromTorso = torsoFromLink[sole].inverse();
    CHECK(distance(soleFromTorso, transform(pose["soleFromTorso"])) < 1e-9);
    const RigidTransform soleFromHead = soleFromTorso * torsoFromLink[*robot.linkIndex("Head")];
    CHECK(distance(soleFromHead, transform(pose["soleFromHead"])) < 1e-9);
    for (const auto& [camera, key] : {std::pair{"top", "soleFromOpticalTop"}, {"bottom", "soleFromOpticalBottom"}}) {
      const CameraMount& mount = robot.cameras[*robot.cameraIndex(camera)];
      const RigidTransform soleFromOptical =
          soleFromTorso * torsoFromLink[mount.link] * linkFromOptical(mount, modelState);
      CHECK(distance(soleFromOptical, transform(pose[key])) < 1e-9);
    }

    const Eigen::Vector3d comInSole = soleFromTorso * centreOfMass(robot, torsoFromLink).inTorso;
    for (int i = 0; i < 3; ++i) {
      CHECK(comInSole[i] == Approx(pose["comInSole"][i].get<double>()).epsilon(0).margin(1e-9));
    }
    const Eigen::Vector3d up = soleFromTorso.rotation.row(2); // the sole lies flat: up is its z axis
    const Eigen::VectorXd torques = gravityTorques(robot, modelState, torsoFromLink, sole, up);
    for (const auto& [name, torque] : pose["torque"].items()) {
      CAPTURE(name);
      CHECK(torques[static_cast<Eigen::Index>(*robot.jointIndex(name))] ==
            Approx(torque.get<double>()).epsilon(0).margin(1e-9));
    }
  }
}
