#include "io/Files.hpp"
#include "robot/Gravity.hpp"
#include "simulation/SyntheticBody.hpp"

#include "SharedData.hpp"
#include "simulation/HandMadePoses.hpp"

#include <nlohmann/json.hpp>

using namespace naocal;

namespace {

Eigen::VectorXd anyAngles(const Robot& robot, RandomStream& chance) {
  Eigen::VectorXd angles{static_cast<Eigen::Index>(robot.joints.size())};
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const AngleRange& limits = robot.joints[joint].limits;
    angles[static_cast<Eigen::Index>(joint)] =
        (limits.lower + limits.upper) / 2 + chance.uniformWithin((limits.upper - limits.lower) / 2);
  }
  return angles;
}

} // namespace

TEST_CASE("with all joints at zero the soles lie 333.09 mm below the torso and the top camera 523.23 mm above them") {
  // Proves the sums of the drawing's lengths, as stated by its sources for the standing NAO. Rotations are not covered.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  const SyntheticBody body{robot};
  const auto torsoFromLink =
      body.forwardKinematics(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.joints.size())));
  CHECK((torsoFromLink[robot.findSole("left")->link].translation() - Eigen::Vector3d{0, 0.05, -0.33309}).norm() <
        1e-12);
  CHECK((torsoFromLink[robot.findSole("right")->link].translation() - Eigen::Vector3d{0, -0.05, -0.33309}).norm() <
        1e-12);
  const CameraMount& top = robot.cameras[*robot.cameraIndex("top")];
  CHECK((torsoFromLink[top.link] * top.translation).z() + 0.33309 == Approx(0.52323));
  CHECK(body.mass() == Approx(5.35979));
}

TEST_CASE("a bent leg is where a product of elementary rotations puts it") {
  // Proves the order, axes and signs of the left leg's joints against the chain in HULKs' kinematics: Tz(-85) Ty(50)
  // Rx(-45 deg) Ry(hyp) Rx(45 deg + roll) Ry(pitch) Tz(-100) Ry(knee) Tz(-102.9) Ry(ankle) Rx(ankle roll) Tz(-45.19),
  // in millimetres. One leg, one pose.
  using Eigen::AngleAxisd, Eigen::Translation3d, Eigen::Vector3d;
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.joints.size()));
  const auto set = [&](const char* joint, double angle) {
    angles[static_cast<Eigen::Index>(*robot.jointIndex(joint))] = angle;
  };
  set("LHipYawPitch", -0.4);
  set("LHipRoll", 0.2);
  set("LHipPitch", -0.7);
  set("LKneePitch", 1.1);
  set("LAnklePitch", -0.5);
  set("LAnkleRoll", -0.15);
  const Eigen::Isometry3d expected =
      Translation3d{0, 0.05, -0.085} * AngleAxisd{radians(-45), Vector3d::UnitX()} *
      AngleAxisd{-0.4, Vector3d::UnitY()} * AngleAxisd{radians(45) + 0.2, Vector3d::UnitX()} *
      AngleAxisd{-0.7, Vector3d::UnitY()} * Translation3d{0, 0, -0.1} * AngleAxisd{1.1, Vector3d::UnitY()} *
      Translation3d{0, 0, -0.1029} * AngleAxisd{-0.5, Vector3d::UnitY()} * AngleAxisd{-0.15, Vector3d::UnitX()} *
      Translation3d{0, 0, -0.04519};
  const Eigen::Isometry3d found = SyntheticBody{robot}.forwardKinematics(angles)[robot.findSole("left")->link];
  CHECK((found.matrix() - expected.matrix()).norm() < 1e-12);
}

TEST_CASE("gravity pulls the head forward by m g (x cos q + z sin q)") {
  // Proves size and sign of one joint's torque by hand: only the head hangs on head pitch. Torso upright.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.joints.size()));
  const auto headPitch = static_cast<Eigen::Index>(*robot.jointIndex("HeadPitch"));
  angles[headPitch] = 0.3;
  const Link& head = robot.links[*robot.linkIndex("Head")];
  const double expected =
      head.mass * 9.81 * (head.centreOfMass.x() * std::cos(0.3) + head.centreOfMass.z() * std::sin(0.3));
  const Eigen::VectorXd torques = SyntheticBody{robot}.gravityTorques(angles, robot.findSole("left")->link);
  CHECK(torques[headPitch] == Approx(expected).margin(1e-7));
}

TEST_CASE("the simulator's mechanics and the calibration's agree in any attitude") {
  // Cross-checks two independent implementations (screws and energy differences here, link by link and closed-form
  // torques there): links and centre of mass agree to 1e-12 m, torques to 1e-6 Nm. Both read the same drawing.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  const SyntheticBody body{robot};
  RandomStream chance{1, "any attitude"};
  for (int attitude = 0; attitude < 50; ++attitude) {
    const Eigen::VectorXd angles = anyAngles(robot, chance);
    const auto ours = body.forwardKinematics(angles);
    const LinkPoses theirs = forwardKinematics(robot, angles);
    for (std::size_t link = 0; link < robot.links.size(); ++link) {
      REQUIRE((ours[link].linear() - theirs[link].rotation).norm() < 1e-12);
      REQUIRE((ours[link].translation() - theirs[link].translation).norm() < 1e-12);
    }
    REQUIRE((body.centreOfMass(ours) - centreOfMass(robot, theirs).inTorso).norm() < 1e-12);
    ModelState modelState = nominalState(robot, StateLayout{robot.joints.size(), robot.lengths.size(), 0});
    modelState.values.head(angles.size()) = angles;
    const std::size_t sole = robot.findSole(attitude % 2 == 0 ? "left" : "right")->link;
    const Eigen::Vector3d up = theirs[sole].rotation.col(2);
    const Eigen::VectorXd torques = gravityTorques(robot, modelState, theirs, sole, up);
    REQUIRE((body.gravityTorques(angles, sole) - torques).cwiseAbs().maxCoeff() < 1e-6);
  }
}

TEST_CASE("links and torques agree with an independent simulator's") {
  // Compares with an independent simulator. Its arms are single masses, rounded to a micrometre, so torques agree to
  // 1e-5 Nm only.
  const auto file = sharedData("conformance/kinematics.json");
  if (!file) {
    return;
  }
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  const SyntheticBody body{robot};
  const nlohmann::json conformance = nlohmann::json::parse(readFile(*file));
  for (const nlohmann::json& pose : conformance["poses"]) {
    Eigen::VectorXd angles{static_cast<Eigen::Index>(robot.joints.size())};
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      angles[static_cast<Eigen::Index>(joint)] =
          pose["joints"].value(robot.joints[joint].name, robot.joints[joint].restAngle);
    }
    const std::size_t sole = robot.findSole(pose["supportFoot"].get<std::string>())->link;
    const auto torsoFromLink = body.forwardKinematics(angles);
    const Eigen::Matrix4d soleFromHead =
        (torsoFromLink[sole].inverse() * torsoFromLink[*robot.linkIndex("Head")]).matrix();
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) {
        CHECK(soleFromHead(row, column) == Approx(pose["soleFromHead"][row][column].get<double>()).margin(1e-9));
      }
    }
    const Eigen::VectorXd torques = body.gravityTorques(angles, sole);
    for (const auto& [joint, torque] : pose["torque"].items()) {
      const auto index = static_cast<Eigen::Index>(*robot.jointIndex(joint));
      CHECK(torques[index] == Approx(torque.get<double>()).margin(1e-5));
    }
  }
}
