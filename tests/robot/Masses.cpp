#include "RobotV6.hpp"
#include "robot/Gravity.hpp"

#include <catch2/catch.hpp>
#include <random>

using namespace naocal;

namespace {

ModelState randomBelief(const Robot& robot, std::mt19937& random) {
  ModelState modelState = nominalState(robot, StateLayout{robot.joints.size(), robot.lengths.size(), 0});
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const AngleRange limits = robot.joints[joint].limits;
    modelState.angle(joint) = std::uniform_real_distribution{limits.lower, limits.upper}(random);
  }
  return modelState;
}

/// Potential U [J] with `heldLink` fixed: weight times height of the centre of mass above it.
double potential(const Robot& robot, const ModelState& modelState, std::size_t heldLink,
                 const Eigen::Vector3d& upInHeld) {
  const LinkPoses torsoFromLink = forwardKinematics(robot, modelState);
  const CentreOfMass centre = centreOfMass(robot, torsoFromLink);
  return gravity * centre.mass * upInHeld.dot(torsoFromLink[heldLink].inverse() * centre.inTorso);
}

} // namespace

TEST_CASE("a gravity torque is the slope of the potential, whichever link is held") {
  // Proves tau = -dU/dq for every motor, for random poses and directions of gravity, with the root, either sole and a
  // hand fixed, against central differences that move all joints of a motor. The masses' values are not tested.
  const Robot robot = v6();
  std::mt19937 random{7};
  std::normal_distribution<double> normal;
  constexpr double step = 1e-5; // [rad]; error of the difference: about step^2 * torque = 1e-9 Nm
  for (const char* held : {"Torso", "LSole", "RSole", "LWrist"}) {
    const std::size_t heldLink = *robot.linkIndex(held);
    for (int attitude = 0; attitude < 20; ++attitude) {
      const ModelState modelState = randomBelief(robot, random);
      const Eigen::Vector3d upInHeld = Eigen::Vector3d{normal(random), normal(random), normal(random)}.normalized();
      const LinkPoses torsoFromLink = forwardKinematics(robot, modelState);
      const Eigen::VectorXd torques =
          gravityTorques(robot, modelState, torsoFromLink, heldLink, torsoFromLink[heldLink].rotation * upInHeld);
      for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
        ModelState more = modelState, less = modelState;
        for (std::size_t moved = 0; moved < robot.joints.size(); ++moved) {
          if (robot.joints[moved].motor == robot.joints[joint].motor) {
            more.angle(moved) += step;
            less.angle(moved) -= step;
          }
        }
        const double slope =
            (potential(robot, more, heldLink, upInHeld) - potential(robot, less, heldLink, upInHeld)) / (2 * step);
        CAPTURE(held, robot.joints[joint].name);
        CHECK(torques[static_cast<Eigen::Index>(joint)] == Approx(-slope).margin(1e-8));
      }
    }
  }
}

TEST_CASE("the centre of mass of the standing robot lies in its middle plane") {
  // Proves that left and right masses of V6's drawing are symmetric, and that all are counted (their sum is HULKs').
  // The position within the plane is tested in Conformance.cpp.
  const Robot robot = v6();
  const ModelState modelState = nominalState(robot, StateLayout{robot.joints.size(), robot.lengths.size(), 0});
  const CentreOfMass centre = centreOfMass(robot, forwardKinematics(robot, modelState));
  CHECK(centre.mass == Approx(5.35979).epsilon(1e-12));
  CHECK(centre.inTorso.y() == Approx(0).margin(1e-12));
}

TEST_CASE("lifting the head against gravity takes the moment of its weight") {
  // Proves sign and size on a case with one lever: head level, torso upright. A centre of mass ahead of the pitch axis
  // would turn HeadPitch to positive angles; V6's is 1.12 mm behind it.
  const Robot robot = v6();
  const ModelState modelState = nominalState(robot, StateLayout{robot.joints.size(), robot.lengths.size(), 0});
  const auto torque = [&](const ModelState& at) {
    return gravityTorques(robot, at, forwardKinematics(robot, at), *robot.linkIndex("LSole"),
                          Eigen::Vector3d::UnitZ())[static_cast<Eigen::Index>(*robot.jointIndex("HeadPitch"))];
  };
  CHECK(torque(modelState) == Approx(-0.65973 * 9.81 * 0.00112));
  ModelState nodding = modelState;
  nodding.angle(*robot.jointIndex("HeadPitch")) = std::acos(-1.0) / 2; // its centre 52.58 mm in front of the axis
  CHECK(torque(nodding) == Approx(0.65973 * 9.81 * 0.05258));
}
