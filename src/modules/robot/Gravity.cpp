#include "robot/Gravity.hpp"

#include "math/LinearAlgebra.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <vector>

namespace naocal {

namespace {

/// A joint with the links it rotates, seen from the held link.
struct Turning {
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();   // points away from the held link: rotates what lies beyond
  Eigen::Vector3d moment = Eigen::Vector3d::Zero(); // axis x sum m (p - pivot): d(sum m p)/dq [kg m/rad]
};

/// Flags the links from the root to `link`.
std::vector<char> carriers(const Robot& robot, std::size_t link) {
  std::vector<char> result(robot.links.size(), 0);
  for (std::optional<std::size_t> at = link; at; at = robot.links[*at].parent) {
    result[*at] = 1;
  }
  return result;
}

/// Lists the joints from `joint` to the held link, itself first: up to the common ancestor, then down.
void listPath(const Robot& robot, std::size_t joint, std::size_t heldLink, const std::vector<char>& carriesHeld,
              std::vector<std::size_t>& way) {
  way.assign(1, joint);
  std::size_t link = robot.joints[joint].link;
  while (carriesHeld[link] == 0) {
    link = *robot.links[link].parent;
    if (carriesHeld[link] == 0 && robot.links[link].joint) {
      way.push_back(*robot.links[link].joint);
    }
  }
  const auto parting = static_cast<std::ptrdiff_t>(way.size());
  for (std::size_t below = heldLink; below != link; below = *robot.links[below].parent) {
    if (robot.links[below].joint) {
      way.push_back(*robot.links[below].joint);
    }
  }
  std::reverse(way.begin() + parting, way.end());
}

/// Adds the third derivative of -U of three joints wherever two of them belong to one motor: the derivative of
/// torqueGrowth with respect to the angle of the third.
void addGrowth(const Robot& robot, std::array<std::size_t, 3> joints, double bend, GravityLoad& load) {
  std::sort(joints.begin(), joints.end());
  do {
    const std::size_t motor = robot.joints[joints[0]].motor;
    if (motor == robot.joints[joints[1]].motor) {
      load.growthByAngle(eigenIndex(motor), eigenIndex(joints[2])) += bend;
    }
  } while (std::next_permutation(joints.begin(), joints.end()));
}

/// Sums of m [kg] and m * p [kg m] over a set of links, p in the torso frame.
struct Moment {
  double mass = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();

  void operator+=(const Moment& other) {
    mass += other.mass;
    first += other.first;
  }
};

/// Per link: sums over itself and all links beyond; at the root those of the whole robot.
std::vector<Moment> moments(const Robot& robot, const LinkPoses& torsoFromLink) {
  std::vector<Moment> beyond(robot.links.size());
  for (std::size_t link = robot.links.size(); link-- > 0;) { // parents precede their children
    const double mass = robot.links[link].mass;
    beyond[link] += {mass, mass * (torsoFromLink[link] * robot.links[link].centreOfMass)};
    if (const auto parent = robot.links[link].parent) {
      beyond[*parent] += beyond[link];
    }
  }
  return beyond;
}

} // namespace

GravityLoad gravityLoad(const Robot& robot, const ModelState& modelState, const LinkPoses& torsoFromLink,
                        std::size_t heldLink, const Eigen::Vector3d& upInTorso, bool withGrowthByAngle) {
  const std::size_t links = robot.links.size(), joints = robot.joints.size();
  std::vector<double> mass(links);
  std::vector<Eigen::Vector3d> first(links, Eigen::Vector3d::Zero()); // sum m p beyond each link, in the torso frame
  for (std::size_t link = links; link-- > 0;) {                       // parents precede their children
    mass[link] += robot.links[link].mass;
    first[link] += robot.links[link].mass * (torsoFromLink[link] * robot.links[link].centreOfMass);
    if (const auto parent = robot.links[link].parent) {
      mass[*parent] += mass[link];
      first[*parent] += first[link];
    }
  }
  const std::vector<char> carriesHeld = carriers(robot, heldLink);
  const Eigen::Matrix3d heldFromTorso = torsoFromLink[heldLink].rotation.transpose();

  const Eigen::Index bent = withGrowthByAngle ? eigenIndex(joints) : 0;
  GravityLoad load{Eigen::VectorXd::Zero(eigenIndex(joints)),
                   Eigen::MatrixXd::Zero(eigenIndex(joints), eigenIndex(joints)),
                   Eigen::VectorXd::Zero(eigenIndex(joints)),
                   Eigen::MatrixXd::Zero(bent, bent),
                   torsoFromLink[heldLink].inverse() * (first.front() / mass.front()),
                   Eigen::Matrix3Xd(3, eigenIndex(joints))};
  std::vector<Turning> turning(joints);
  for (std::size_t joint = 0; joint < joints; ++joint) {
    const std::size_t link = robot.joints[joint].link;
    const Eigen::Vector3d axis = torsoFromLink[link].rotation * modelState.axis(joint);
    const bool backwards = carriesHeld[link] != 0; // rotates the links before the joint, in the opposite direction
    const double turned = mass[link] - (backwards ? mass.front() : 0);
    const Eigen::Vector3d lever =
        first[link] - (backwards ? first.front() : Eigen::Vector3d::Zero()) - turned * torsoFromLink[link].translation;
    turning[joint] = {backwards ? Eigen::Vector3d{-axis} : axis, axis.cross(lever)};
    load.comByAngle.col(eigenIndex(joint)) = heldFromTorso * turning[joint].moment / mass.front();
  }
  const auto couple = [&](std::size_t nearer, std::size_t beyond) {
    const double slope = -gravity * upInTorso.dot(turning[nearer].axis.cross(turning[beyond].moment));
    load.torqueByAngle(eigenIndex(nearer), eigenIndex(beyond)) =
        load.torqueByAngle(eigenIndex(beyond), eigenIndex(nearer)) = slope;
  };
  std::vector<std::size_t> way;
  for (std::size_t joint = 0; joint < joints; ++joint) {
    load.torque[eigenIndex(joint)] = -gravity * upInTorso.dot(turning[joint].moment);
    listPath(robot, joint, heldLink, carriesHeld, way);
    for (std::size_t i = 0; i < way.size(); ++i) {
      couple(way[i], joint);
      for (std::size_t j = i; withGrowthByAngle && j < way.size(); ++j) {
        const Eigen::Vector3d bend = turning[way[i]].axis.cross(turning[joint].moment);
        addGrowth(robot, {joint, way[i], way[j]}, -gravity * upInTorso.dot(turning[way[j]].axis.cross(bend)), load);
      }
    }
  }
  for (std::size_t joint = 0; joint < joints; ++joint) { // a motor rotates all its joints
    for (std::size_t other = 0; other < joints; ++other) {
      if (robot.joints[other].motor == robot.joints[joint].motor) {
        load.torqueGrowth[eigenIndex(robot.joints[joint].motor)] +=
            load.torqueByAngle(eigenIndex(joint), eigenIndex(other));
      }
    }
  }
  for (std::size_t joint = 0; joint < joints; ++joint) { // and bears the sum of their torques
    const std::size_t motor = robot.joints[joint].motor;
    if (motor != joint) {
      load.torque[eigenIndex(motor)] += load.torque[eigenIndex(joint)];
      load.torqueByAngle.row(eigenIndex(motor)) += load.torqueByAngle.row(eigenIndex(joint));
      load.torque[eigenIndex(joint)] = load.torque[eigenIndex(motor)];
      load.torqueByAngle.row(eigenIndex(joint)) = load.torqueByAngle.row(eigenIndex(motor));
      load.torqueGrowth[eigenIndex(joint)] = load.torqueGrowth[eigenIndex(motor)];
      if (withGrowthByAngle) {
        load.growthByAngle.row(eigenIndex(joint)) = load.growthByAngle.row(eigenIndex(motor));
      }
    }
  }
  return load;
}

CentreOfMass centreOfMass(const Robot& robot, const LinkPoses& torsoFromLink) {
  Moment whole;
  for (std::size_t link = 0; link < robot.links.size(); ++link) {
    const double mass = robot.links[link].mass;
    whole += {mass, mass * (torsoFromLink[link] * robot.links[link].centreOfMass)};
  }
  assert(whole.mass > 0);
  return {whole.mass, whole.first / whole.mass};
}

Eigen::VectorXd gravityTorques(const Robot& robot, const ModelState& modelState, const LinkPoses& torsoFromLink,
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
    // The angle rotates all links beyond the joint; if the held link is among them, all links before it, backwards.
    Moment turning = beyond[link];
    if (carriesHeld[link]) {
      turning = {turning.mass - beyond.front().mass, turning.first - beyond.front().first};
    }
    const Eigen::Vector3d axis = torsoFromThis.rotation * modelState.axis(joint);
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
