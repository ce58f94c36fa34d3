#include "model/Masses.hpp"

#include <Eigen/Geometry>
#include <cassert>
#include <vector>

namespace naocal {

namespace {

/// sum of m [kg] and of m * p, p in the torso's frame [kg m], over a set of links.
struct Moment {
  double mass = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();

  void operator+=(const Moment& other) {
    mass += other.mass;
    first += other.first;
  }
};

/// Per link: the moment of itself and everything beyond it; at the root that of the whole robot.
std::vector<Moment> moments(const Robot& robot, const Posture& torsoFromLink) {
  std::vector<Moment> beyond(robot.links.size());
  for (std::size_t link = robot.links.size(); link-- > 0;) { // children stand behind their parents
    const double mass = robot.links[link].mass;
    beyond[link] += {mass, mass * (torsoFromLink[link] * robot.links[link].centreOfMass)};
    if (const auto parent = robot.links[link].parent) {
      beyond[*parent] += beyond[link];
    }
  }
  return beyond;
}

} // namespace

CentreOfMass centreOfMass(const Robot& robot, const Posture& torsoFromLink) {
  Moment whole;
  for (std::size_t link = 0; link < robot.links.size(); ++link) {
    const double mass = robot.links[link].mass;
    whole += {mass, mass * (torsoFromLink[link] * robot.links[link].centreOfMass)};
  }
  assert(whole.mass > 0);
  return {whole.mass, whole.first / whole.mass};
}

Eigen::VectorXd gravityTorques(const Robot& robot, const Belief& belief, const Posture& torsoFromLink,
                               std::size_t heldLink, const Eigen::Vector3d& upInTorso) {
  const std::vector<Moment> beyond = moments(robot, torsoFromLink);
  std::vector<bool> carriesHeld(robot.links.size(), false);
  for (std::optional<std::size_t> link = heldLink; link; link = robot.links[*link].parent) {
    carriesHeld[*link] = true;
  }
  Eigen::VectorXd torques = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.joints.size()));
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const std::size_t link = robot.joints[joint].link;
    const RigidTransform& torsoFromThis = torsoFromLink[link];
    // What turns with the angle: all beyond the joint; or, if the held link is there, all before it, backwards.
    Moment turning = beyond[link];
    if (carriesHeld[link]) {
      turning = {turning.mass - beyond.front().mass, turning.first - beyond.front().first};
    }
    const Eigen::Vector3d axis = torsoFromThis.rotation * belief.axis(joint);
    const Eigen::Vector3d lever = turning.first - turning.mass * torsoFromThis.translation;
    const double torque = -gravity * upInTorso.dot(axis.cross(lever));
    torques[static_cast<Eigen::Index>(robot.joints[joint].motor)] += torque;
  }
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    torques[static_cast<Eigen::Index>(joint)] = torques[static_cast<Eigen::Index>(robot.joints[joint].motor)];
  }
  return torques;
}

} // namespace naocal
