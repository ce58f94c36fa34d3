#include "SharedData.hpp"
#include "robot/Kinematics.hpp"
#include "robot/RobotOfSet.hpp"
#include "robot/Urdf.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

namespace naocal {
namespace {

const std::filesystem::path shipped = std::filesystem::path{NAOCAL_SOURCE_DIR} / "home/configuration";

} // namespace

TEST_CASE("the K1's drawing is the robot of its URDF") {
  // Proves links, joints, limits, masses and the tree's kinematics against the URDF that the drawing's numbers come
  // from. Lengths, camera and soles are the drawing's own; of the soles only their height is tested.
  const auto file = sharedData("robots/k1.urdf");
  if (!file) {
    return;
  }
  const Robot k1 = loadRobot(shipped, "K1"), urdf = loadUrdf(*file);
  REQUIRE(k1.joints.size() == urdf.joints.size());
  Eigen::VectorXd angles{static_cast<Eigen::Index>(k1.joints.size())}, same = angles;
  for (std::size_t joint = 0; joint < k1.joints.size(); ++joint) {
    const std::size_t other = urdf.jointIndex(k1.joints[joint].name).value();
    CHECK(k1.joints[joint].limits.lower == Approx(urdf.joints[other].limits.lower).margin(1e-5));
    CHECK(k1.joints[joint].limits.upper == Approx(urdf.joints[other].limits.upper).margin(1e-5));
    CHECK(k1.joints[joint].maxSpeed == Approx(urdf.joints[other].maxSpeed).epsilon(1e-4));
    angles[static_cast<Eigen::Index>(joint)] = same[static_cast<Eigen::Index>(other)] =
        std::sin(7.0 * static_cast<double>(joint));
  }
  const LinkPoses drawn = forwardKinematics(k1, angles), expected = forwardKinematics(urdf, same);
  for (std::size_t link = 0; link < urdf.links.size(); ++link) {
    const std::size_t own = k1.linkIndex(urdf.links[link].name).value();
    CHECK((drawn[own].translation - expected[link].translation).norm() < 1e-9);
    CHECK((drawn[own].rotation - expected[link].rotation).norm() < 1e-9);
    CHECK(k1.links[own].mass == urdf.links[link].mass);
    CHECK((k1.links[own].centreOfMass - urdf.links[link].centreOfMass).norm() < 1e-9);
  }
  for (const Sole& sole : k1.soles) {
    CHECK(k1.links[sole.link].parent == k1.linkIndex(sole.name + "_foot_link"));
    CHECK(sole.outline.size() == 4);
  }
}

TEST_CASE("a set of a shipped robot names that robot's joints") {
  // Proves it for a model that is no NAO, whose names the reader of sets does not know.
  CaptureSet set;
  set.name = "set";
  set.model = "K1";
  set.jointNames = {"Left_Knee_Pitch", "Head_pitch"};
  CHECK(loadRobot(set, shipped).model == "K1");
  set.jointNames.push_back("LKneePitch");
  CHECK_THROWS_WITH(loadRobot(set, shipped),
                    "set: jointNames: expected movable joints of the K1, found \"LKneePitch\"");
}

} // namespace naocal
