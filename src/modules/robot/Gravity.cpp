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

/// A joint with the links it moves, seen from the held link.
struct Turning {
  Eigen::Vector3d axis =
      Eigen::Vector3d::Zero(); // points away from the held link: rotates what lies beyond; prismatic: 0
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
      const double ratio = robot.joints[joints[0]].ratio * robot.joints[joints[1]].ratio;
      load.growthByAngle(eigenIndex(motor), eigenIndex(joints[2])) += ratio * bend;
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

/// Robot in a pose with one link held.
struct HeldRobot {
  const Robot& robot;
  const ModelState& modelState;
  const LinkPoses& torsoFromLink;
  Eigen::Vector3d upInTorso;
  std::vector<char> carriesHeld; // per link: nonzero from the root to the held link
  std::vector<Moment> beyond;    // per link, as `moments`
};

/// Sums over the links that a joint's angle moves: all beyond it; if the held link is among them, all before it,
/// negative as they move backwards.
Moment movedBy(const HeldRobot& held, std::size_t link) {
  Moment moved = held.beyond[link];
  if (held.carriesHeld[link] != 0) {
    const Moment& whole = held.beyond.front();
    moved = {moved.mass - whole.mass, moved.first - whole.first};
  }
  return moved;
}

/// Sum of m (p - pivot) over the links that a joint moves, in the torso frame [kg m].
Eigen::Vector3d leverOf(const HeldRobot& held, std::size_t link) {
  const Moment moved = movedBy(held, link);
  return moved.first - moved.mass * held.torsoFromLink[link].translation;
}

Turning turningOf(const HeldRobot& held, std::size_t joint) {
  const std::size_t link = held.robot.joints[joint].link;
  const Eigen::Vector3d axis = held.torsoFromLink[link].rotation * held.modelState.axis(joint);
  if (held.robot.joints[joint].isPrismatic) {
    return {Eigen::Vector3d::Zero(), axis * movedBy(held, link).mass};
  }
  return {held.carriesHeld[link] != 0 ? Eigen::Vector3d{-axis} : axis, axis.cross(leverOf(held, link))};
}

GravityLoad zeroLoad(const Robot& robot, bool withGrowthByAngle) {
  const Eigen::Index joints = eigenIndex(robot.joints.size()), bent = withGrowthByAngle ? joints : 0;
  return {Eigen::VectorXd::Zero(joints), Eigen::MatrixXd::Zero(joints, joints),
          Eigen::VectorXd::Zero(joints), Eigen::MatrixXd::Zero(bent, bent),
          Eigen::Vector3d{0, 0, 0},      Eigen::Matrix3Xd(3, joints)};
}

/// Adds the second derivatives of -U, and the third if `load` has them, of `joint` with the joints of `way` before it
/// (`listPath`).
void addCouplings(const HeldRobot& held, const std::vector<Turning>& turning, const std::vector<std::size_t>& way,
                  GravityLoad& load) {
  const std::size_t joint = way.front();
  for (std::size_t i = 0; i < way.size(); ++i) {
    const Eigen::Vector3d bend = turning[way[i]].axis.cross(turning[joint].moment);
    load.torqueByAngle(eigenIndex(way[i]), eigenIndex(joint)) =
        load.torqueByAngle(eigenIndex(joint), eigenIndex(way[i])) = -gravity * held.upInTorso.dot(bend);
    for (std::size_t j = i; load.growthByAngle.size() > 0 && j < way.size(); ++j) {
      addGrowth(held.robot, {joint, way[i], way[j]}, -gravity * held.upInTorso.dot(turning[way[j]].axis.cross(bend)),
                load);
    }
  }
}

/// Sets `torqueGrowth` of each motor: a motor moves all its joints, by their ratios.
void sumTorqueGrowth(const Robot& robot, GravityLoad& load) {
  const std::size_t joints = robot.joints.size();
  for (std::size_t joint = 0; joint < joints; ++joint) {
    for (std::size_t other = 0; other < joints; ++other) {
      if (robot.joints[other].motor == robot.joints[joint].motor) {
        load.torqueGrowth[eigenIndex(robot.joints[joint].motor)] +=
            robot.joints[joint].ratio * robot.joints[other].ratio *
            load.torqueByAngle(eigenIndex(joint), eigenIndex(other));
      }
    }
  }
}

/// Gives all joints of a motor the sum of their torques times their ratios, which it bears.
void sumTorquesOfMotors(const Robot& robot, GravityLoad& load) {
  for (std::size_t number = 0; number < robot.joints.size(); ++number) {
    const Eigen::Index joint = eigenIndex(number), motor = eigenIndex(robot.joints[number].motor);
    if (motor != joint) {
      load.torque[motor] += robot.joints[number].ratio * load.torque[joint];
      load.torqueByAngle.row(motor) += robot.joints[number].ratio * load.torqueByAngle.row(joint);
    }
  }
  for (std::size_t number = 0; number < robot.joints.size(); ++number) {
    const Eigen::Index joint = eigenIndex(number), motor = eigenIndex(robot.joints[number].motor);
    if (motor != joint) {
      load.torque[joint] = load.torque[motor];
      load.torqueByAngle.row(joint) = load.torqueByAngle.row(motor);
      load.torqueGrowth[joint] = load.torqueGrowth[motor];
      if (load.growthByAngle.size() > 0) {
        load.growthByAngle.row(joint) = load.growthByAngle.row(motor);
      }
    }
  }
}

} // namespace

GravityLoad gravityLoad(const Robot& robot, const ModelState& modelState, const LinkPoses& torsoFromLink,
                        std::size_t heldLink, const Eigen::Vector3d& upInTorso, bool withGrowthByAngle) {
  const HeldRobot held{
      robot, modelState, torsoFromLink, upInTorso, carriers(robot, heldLink), moments(robot, torsoFromLink)};
  const Moment& whole = held.beyond.front();
  const Eigen::Matrix3d heldFromTorso = torsoFromLink[heldLink].rotation.transpose();
  GravityLoad load = zeroLoad(robot, withGrowthByAngle);
  load.com = torsoFromLink[heldLink].inverse() * (whole.first / whole.mass);
  std::vector<Turning> turning(robot.joints.size());
  for (std::size_t joint = 0; joint < turning.size(); ++joint) {
    turning[joint] = turningOf(held, joint);
    load.torque[eigenIndex(joint)] = -gravity * upInTorso.dot(turning[joint].moment);
    load.comByAngle.col(eigenIndex(joint)) = heldFromTorso * turning[joint].moment / whole.mass;
  }
  std::vector<std::size_t> way;
  for (std::size_t joint = 0; joint < turning.size(); ++joint) {
    listPath(robot, joint, heldLink, held.carriesHeld, way);
    addCouplings(held, turning, way, load);
  }
  sumTorqueGrowth(robot, load);
  sumTorquesOfMotors(robot, load);
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
  const HeldRobot held{
      robot, modelState, torsoFromLink, upInTorso, carriers(robot, heldLink), moments(robot, torsoFromLink)};
  Eigen::VectorXd torques = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.joints.size()));
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const double torque = -gravity * upInTorso.dot(turningOf(held, joint).moment);
    torques[static_cast<Eigen::Index>(robot.joints[joint].motor)] += robot.joints[joint].ratio * torque;
  }
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    torques[static_cast<Eigen::Index>(joint)] = torques[static_cast<Eigen::Index>(robot.joints[joint].motor)];
  }
  return torques;
}

Eigen::Matrix2Xd lateralTorques(const Robot& robot, const ModelState& modelState, const LinkPoses& torsoFromLink,
                                std::size_t heldLink, const Eigen::Vector3d& upInTorso) {
  const HeldRobot held{
      robot, modelState, torsoFromLink, upInTorso, carriers(robot, heldLink), moments(robot, torsoFromLink)};
  Eigen::Matrix2Xd torques{2, eigenIndex(robot.joints.size())};
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const std::size_t link = robot.joints[joint].link;
    const Eigen::Vector3d lever = leverOf(held, link);
    const auto normals = bearingNormals(modelState.axis(joint));
    const double turned = robot.joints[joint].isPrismatic ? 0 : modelState.angle(joint);
    const Eigen::Matrix3d torsoFromBearing =
        torsoFromLink[link].rotation * rotationAbout(-turned * modelState.axis(joint));
    for (Eigen::Index i = 0; i < 2; ++i) {
      const Eigen::Vector3d normal = torsoFromBearing * normals[static_cast<std::size_t>(i)];
      torques(i, eigenIndex(joint)) = -gravity * upInTorso.dot(normal.cross(lever));
    }
  }
  return torques;
}

} // namespace naocal
