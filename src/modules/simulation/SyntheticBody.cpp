#include "simulation/SyntheticBody.hpp"

#include <numeric>

namespace naocal {

SyntheticBody::SyntheticBody(const Robot& drawing) {
  for (const Link& link : drawing.links) {
    Eigen::Vector3d point = link.constant;
    for (const Link::Stretch& stretch : link.stretches) {
      point += drawing.lengths[stretch.length].value * stretch.direction;
    }
    if (link.parent) {
      point += parts_[*link.parent].point;
    }
    const Eigen::Vector3d axis = link.joint ? drawing.joints[*link.joint].axis : Eigen::Vector3d::UnitZ();
    parts_.push_back({link.parent, link.joint, point, axis, link.mass, link.centreOfMass});
  }
  for (const Joint& joint : drawing.joints) {
    motors_.push_back(joint.motor);
  }
}

std::vector<Eigen::Isometry3d> SyntheticBody::forwardKinematics(const Eigen::VectorXd& angles) const {
  std::vector<Eigen::Isometry3d> moved(parts_.size(), Eigen::Isometry3d::Identity());
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Part& part = parts_[i];
    if (part.parent) {
      moved[i] = moved[*part.parent];
    }
    if (part.joint) {
      const Eigen::Matrix3d turn =
          Eigen::AngleAxisd{angles[static_cast<Eigen::Index>(*part.joint)], part.axis}.toRotationMatrix();
      Eigen::Isometry3d screw = Eigen::Isometry3d::Identity();
      screw.linear() = turn;
      screw.translation() = part.point - turn * part.point;
      moved[i] = moved[i] * screw;
    }
  }
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    moved[i].translate(parts_[i].point);
  }
  return moved;
}

double SyntheticBody::mass() const {
  return std::accumulate(parts_.begin(), parts_.end(), 0.0,
                         [](double sum, const Part& part) { return sum + part.mass; });
}

Eigen::Vector3d SyntheticBody::centreOfMass(const std::vector<Eigen::Isometry3d>& torsoFromLink) const {
  Eigen::Vector3d moment = Eigen::Vector3d::Zero(); // [kg m]
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    moment += parts_[i].mass * (torsoFromLink[i] * parts_[i].centreOfMass);
  }
  return moment / mass();
}

double SyntheticBody::potentialEnergy(const Eigen::VectorXd& angles, std::size_t heldLink) const {
  constexpr double gravity = 9.81; // [m/s^2]
  const std::vector<Eigen::Isometry3d> torsoFromLink = forwardKinematics(angles);
  return mass() * gravity * (torsoFromLink[heldLink].inverse() * centreOfMass(torsoFromLink)).z();
}

Eigen::VectorXd SyntheticBody::gravityTorques(const Eigen::VectorXd& angles, std::size_t heldLink) const {
  constexpr double step = 1e-4; // [rad]
  Eigen::VectorXd torques{angles.size()};
  const auto energyAfterTurning = [&](std::size_t motor, double turn) {
    Eigen::VectorXd turned = angles;
    for (std::size_t joint = 0; joint < motors_.size(); ++joint) {
      turned[static_cast<Eigen::Index>(joint)] += motors_[joint] == motor ? turn : 0;
    }
    return potentialEnergy(turned, heldLink);
  };
  for (std::size_t joint = 0; joint < motors_.size(); ++joint) {
    const std::size_t motor = motors_[joint];
    torques[static_cast<Eigen::Index>(joint)] =
        -(energyAfterTurning(motor, step) - energyAfterTurning(motor, -step)) / (2 * step);
  }
  return torques;
}

} // namespace naocal
