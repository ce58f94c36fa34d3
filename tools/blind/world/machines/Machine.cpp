#include "world/machines/Machine.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>

namespace blind {

namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

Matrix3d turnedBy(const Vector3d& turns) { // Rx Ry Rz
  return rotationAbout(Vector3d::UnitX(), turns.x()) * rotationAbout(Vector3d::UnitY(), turns.y()) *
         rotationAbout(Vector3d::UnitZ(), turns.z());
}

std::string listed(const Vector3d& vector) {
  return fmt::format("{:.17g} {:.17g} {:.17g}", vector.x(), vector.y(), vector.z());
}

const std::string& linkName(const Machine& machine, int joint) {
  static const std::string base = "base";
  return joint < 0 ? base : machine.joints[static_cast<std::size_t>(joint)].link;
}

std::string jointText(const Machine& machine, const Machine::Joint& joint) {
  return fmt::format("  <joint name=\"{}\" type=\"{}\">\n"
                     "    <parent link=\"{}\"/><child link=\"{}\"/>\n"
                     "    <origin xyz=\"{}\" rpy=\"{}\"/><axis xyz=\"{}\"/>\n"
                     "    <limit lower=\"{:.17g}\" upper=\"{:.17g}\" effort=\"300\" velocity=\"2\"/>\n"
                     "  </joint>\n",
                     joint.name, joint.slides ? "prismatic" : "revolute", linkName(machine, joint.parent), joint.link,
                     listed(joint.xyz), listed(joint.rpy), listed(joint.axis), joint.lower, joint.upper);
}

std::string linkText(const std::string& name, double kilograms, const Vector3d& centre) {
  if (kilograms == 0) {
    return fmt::format("  <link name=\"{}\"/>\n", name);
  }
  const double inertia = 0.01 * kilograms; // [kg m^2]; no effect at rest
  return fmt::format("  <link name=\"{0}\"><inertial><origin xyz=\"{1}\"/><mass value=\"{2:.17g}\"/>"
                     "<inertia ixx=\"{3:.6g}\" ixy=\"0\" ixz=\"0\" iyy=\"{3:.6g}\" iyz=\"0\" izz=\"{3:.6g}\"/>"
                     "</inertial></link>\n",
                     name, listed(centre), kilograms, inertia);
}

} // namespace

std::string urdfText(const Machine& machine) {
  std::string text =
      fmt::format("<robot name=\"{}\">\n", machine.name) + linkText("base", machine.baseKilograms, machine.baseCentre);
  for (const Machine::Joint& joint : machine.joints) {
    text += linkText(joint.link, joint.kilograms, joint.centre) + jointText(machine, joint);
  }
  for (const Machine::Attached& fixed : machine.attached) {
    text +=
        fmt::format("  <link name=\"{0}\"/>\n  <joint name=\"{0}_mount\" type=\"fixed\">\n"
                    "    <parent link=\"{1}\"/><child link=\"{0}\"/><origin xyz=\"{2}\" rpy=\"{3}\"/>\n  </joint>\n",
                    fixed.link, linkName(machine, fixed.joint), listed(fixed.xyz), listed(fixed.rpy));
  }
  return text + "</robot>\n";
}

Transform originTransform(const Vector3d& xyz, const Vector3d& rpy) {
  return {rotationAbout(Vector3d::UnitZ(), rpy.z()) * tiltRotation(rpy.x(), rpy.y()), xyz};
}

Vector3d rollPitchYaw(const Matrix3d& turn) {
  return {std::atan2(turn(2, 1), turn(2, 2)), std::atan2(-turn(2, 0), std::hypot(turn(2, 1), turn(2, 2))),
          std::atan2(turn(1, 0), turn(0, 0))};
}

std::array<Vector3d, 2> normalsOf(const Vector3d& axis) {
  Index along = 0;
  axis.cwiseAbs().maxCoeff(&along);
  const Vector3d next = Vector3d::Unit((along + 1) % 3);
  if (axis[along] == 1) {
    return {next, Vector3d::Unit((along + 2) % 3)};
  }
  const Vector3d first = (next - next.dot(axis) * axis).normalized();
  return {first, axis.cross(first)};
}

MachineBody::MachineBody(const Machine& machine, const MachineFlaws& flaws, const Transform& worldFromSole)
    : machine_{machine}, flaws_{flaws}, worldFromSole_{worldFromSole}, standing_(machine.joints.size(), false),
      beyond_(machine.joints.size()) {
  for (int joint = machine.sole ? static_cast<int>(machine.sole->joint) : -1; joint >= 0;
       joint = machine.joints[joint].parent) {
    standing_[static_cast<std::size_t>(joint)] = true;
  }
  for (std::size_t i = 0; i < machine.joints.size(); ++i) {
    const Machine::Joint& joint = machine.joints[i];
    const MachineFlaws::Link& link = flaws.links[i];
    origins_.push_back(originTransform(joint.xyz, joint.rpy) * Transform{turnedBy(link.turn), link.shift});
    drawn_.push_back(joint.axis.normalized());
    const auto [first, second] = normalsOf(drawn_.back());
    axes_.push_back(rotationAbout(first, flaws.joints[i].tiltAlpha) * rotationAbout(second, flaws.joints[i].tiltBeta) *
                    drawn_.back());
    for (int upward = static_cast<int>(i); upward >= 0; upward = machine.joints[upward].parent) {
      beyond_[static_cast<std::size_t>(upward)].push_back(i);
    }
    yields_ = yields_ || flaws.joints[i].compliance != 0 || link.bearing != Eigen::Vector2d::Zero();
  }
}

MachineBody::Posture MachineBody::posture(const VectorXd& angles, const Loads& loads) const {
  Posture result;
  for (std::size_t i = 0; i < machine_.joints.size(); ++i) {
    const Machine::Joint& joint = machine_.joints[i];
    Transform hinge =
        joint.parent < 0 ? origins_[i] : result.links[static_cast<std::size_t>(joint.parent)] * origins_[i];
    const Eigen::Vector2d& bearing = flaws_.links[i].bearing;
    if (bearing != Eigen::Vector2d::Zero() && !loads.empty()) {
      const auto [first, second] = normalsOf(drawn_[i]);
      hinge.turn = hinge.turn * rotationAbout(first, bearing.x() * loads[i].dot(first)) *
                   rotationAbout(second, bearing.y() * loads[i].dot(second));
    }
    const double angle = angles[static_cast<Index>(i)];
    const Transform motion = joint.slides ? Transform{Matrix3d::Identity(), angle * axes_[i]}
                                          : Transform{rotationAbout(axes_[i], angle), Vector3d::Zero()};
    result.links.push_back(hinge * motion);
    result.hinges.push_back(std::move(hinge));
  }
  if (machine_.sole) {
    const Transform footFromSole = originTransform(machine_.sole->xyz, machine_.sole->rpy);
    result.base = worldFromSole_ * (result.links[machine_.sole->joint] * footFromSole).inverse();
    for (std::size_t i = 0; i < result.links.size(); ++i) {
      result.hinges[i] = result.base * result.hinges[i];
      result.links[i] = result.base * result.links[i];
    }
  }
  return result;
}

std::pair<Vector3d, Vector3d> MachineBody::loadOn(const Posture& posture, std::size_t joint) const {
  Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
  const auto add = [&](double kilograms, const Vector3d& centre) {
    const Vector3d weight = -kilograms * gravity * Vector3d::UnitZ();
    force += weight;
    moment += (centre - posture.hinges[joint].shift).cross(weight);
  };
  std::vector<bool> isBeyond(posture.links.size(), false);
  for (const std::size_t other : beyond_[joint]) {
    isBeyond[other] = true;
  }
  for (std::size_t other = 0; other < posture.links.size(); ++other) {
    if (isBeyond[other] != standing_[joint]) {
      add(machine_.joints[other].kilograms, posture.links[other] * machine_.joints[other].centre);
    }
  }
  if (!standing_[joint]) {
    return {force, moment};
  }
  add(machine_.baseKilograms, posture.base * machine_.baseCentre);
  return {-force, -moment}; // what it carries turns the other way
}

VectorXd MachineBody::torques(const Posture& posture) const {
  VectorXd result{static_cast<Index>(machine_.joints.size())};
  for (std::size_t i = 0; i < machine_.joints.size(); ++i) {
    const auto [force, moment] = loadOn(posture, i);
    const Vector3d axis = posture.hinges[i].turn * axes_[i];
    result[static_cast<Index>(i)] = axis.dot(machine_.joints[i].slides ? force : moment);
  }
  return result;
}

MachineBody::Posture MachineBody::settled(const VectorXd& angles) const {
  Posture result = posture(angles, {});
  constexpr int rounds = 4; // each reduces the error to a few percent or less
  for (int round = 0; yields_ && round < rounds; ++round) {
    const VectorXd torque = torques(result);
    VectorXd sagged = angles;
    Loads loads;
    for (std::size_t i = 0; i < machine_.joints.size(); ++i) {
      sagged[static_cast<Index>(i)] += flaws_.joints[i].compliance * torque[static_cast<Index>(i)];
      loads.push_back(result.hinges[i].turn.transpose() * loadOn(result, i).second);
    }
    result = posture(sagged, loads);
  }
  return result;
}

Transform MachineBody::worldFromAttached(const Posture& posture, std::size_t which) const {
  const Machine::Attached& fixed = machine_.attached[which];
  const Transform origin = originTransform(fixed.xyz, fixed.rpy);
  return fixed.joint < 0 ? posture.base * origin : posture.links[static_cast<std::size_t>(fixed.joint)] * origin;
}

} // namespace blind
