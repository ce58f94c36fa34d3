#include "world/Skeleton.hpp"

#include <cmath>

namespace blind {

namespace {

/// Tilts an axis about two directions: (y, z) for x, (z, x) for y, (x, y) for z; for the hip's skew axis x
/// and axis * x.
Eigen::Vector3d tiltedAxis(const Eigen::Vector3d& axis, const JointFlaws& flaws) {
  if (flaws.tiltAlpha == 0 && flaws.tiltBeta == 0) {
    return axis;
  }
  const auto unit = [](Eigen::Index i) { return Eigen::Vector3d::Unit(i % 3); };
  Eigen::Index along = 0;
  const bool isSkew = axis.cwiseAbs().maxCoeff(&along) < 0.99;
  const Eigen::Vector3d first = isSkew ? unit(0) : unit(along + 1);
  const Eigen::Vector3d second = isSkew ? Eigen::Vector3d{axis.cross(unit(0))} : unit(along + 2);
  return rotationAbout(first, flaws.tiltAlpha) * rotationAbout(second, flaws.tiltBeta) * axis;
}

} // namespace

Eigen::Matrix3d rotationAbout(const Eigen::Vector3d& axis, double angle) {
  const double sine = std::sin(angle), rest = 1 - std::cos(angle);
  Eigen::Matrix3d cross;
  cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  return Eigen::Matrix3d::Identity() + sine * cross + rest * cross * cross;
}

Transform floorTransform(double x, double y, double yaw) {
  return {rotationAbout(Eigen::Vector3d::UnitZ(), yaw), {x, y, 0}};
}

Eigen::Matrix3d tiltRotation(double roll, double pitch) {
  return rotationAbout(Eigen::Vector3d::UnitY(), pitch) * rotationAbout(Eigen::Vector3d::UnitX(), roll);
}

Skeleton::Skeleton(const Drawing& drawing, const Flaws& flaws) : drawing_{drawing} {
  const auto length = [&](const std::string& name) {
    const auto change = flaws.lengths.find(name);
    return drawing.lengths.at(name) + (change == flaws.lengths.end() ? 0 : change->second);
  };
  for (std::size_t i = 0; i < drawing.joints.size(); ++i) {
    const Drawing::Joint& joint = drawing.joints[i];
    Eigen::Vector3d point = joint.fixedPlace;
    for (const auto& [name, direction] : joint.alongLengths) {
      point += length(name) * direction;
    }
    screws_.push_back({joint.parent, tiltedAxis(joint.axis, flaws.joints[i]), point});
  }
  const auto place = [&](int joint) { return joint < 0 ? Eigen::Vector3d{0, 0, 0} : screws_[joint].point; };
  for (const Drawing::Mass& mass : drawing.masses) {
    weights_.push_back({mass.joint, mass.kilograms, place(mass.joint) + mass.inLink});
    mass_ += mass.kilograms;
  }
  for (std::size_t side = 0; side < 2; ++side) {
    soles_[side] = place(drawing.soles[side].joint) - length("footZ") * Eigen::Vector3d::UnitZ();
    inLeg_[side].assign(screws_.size(), false);
    for (int joint = drawing.soles[side].joint; joint >= 0; joint = screws_[joint].parent) {
      inLeg_[side][joint] = true;
    }
  }
}

Skeleton::Posture Skeleton::posture(const Eigen::VectorXd& angles) const {
  Posture posture(screws_.size());
  for (std::size_t i = 0; i < screws_.size(); ++i) {
    const Screw& screw = screws_[i];
    Transform turning;
    turning.turn = rotationAbout(screw.axis, angles[static_cast<Eigen::Index>(i)]);
    turning.shift = screw.point - turning.turn * screw.point;
    posture[i] = screw.parent < 0 ? turning : posture[screw.parent] * turning;
  }
  return posture;
}

Transform Skeleton::torsoFromSole(const Posture& posture, int side) const {
  return posture[drawing_.soles[side].joint] * Transform{Eigen::Matrix3d::Identity(), soles_[side]};
}

Transform Skeleton::torsoFromCamera(const Posture& posture, int camera, const Eigen::Matrix3d& mountTurn,
                                    const Eigen::Vector3d& shift) const {
  const Drawing::Camera& drawn = drawing_.cameras[camera];
  const Transform mount{rotationAbout(Eigen::Vector3d::UnitY(), drawn.pitch) * mountTurn,
                        screws_[drawn.joint].point + drawn.inLink + shift};
  return posture[drawn.joint] * mount;
}

Eigen::Vector3d Skeleton::centre(const Posture& posture, const Weight& weight) const {
  return weight.joint < 0 ? weight.point : posture[weight.joint] * weight.point;
}

Eigen::Vector3d Skeleton::centreOfMass(const Posture& posture) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Weight& weight : weights_) {
    sum += weight.kilograms * centre(posture, weight);
  }
  return sum / mass_;
}

/// A joint of the support leg moves everything above it in the opposite direction; other joints move what hangs on
/// them.
Eigen::VectorXd Skeleton::torques(const Posture& posture, int side, const Eigen::Vector3d& up) const {
  std::vector<double> carried(screws_.size(), 0.0); // per joint: mass beyond it
  std::vector<Eigen::Vector3d> moment(screws_.size(), Eigen::Vector3d::Zero());
  Eigen::Vector3d wholeMoment = Eigen::Vector3d::Zero();
  for (const Weight& weight : weights_) {
    const Eigen::Vector3d point = centre(posture, weight);
    wholeMoment += weight.kilograms * point;
    if (weight.joint >= 0) {
      carried[weight.joint] += weight.kilograms;
      moment[weight.joint] += weight.kilograms * point;
    }
  }
  for (std::size_t i = screws_.size(); i-- > 0;) {
    if (const int parent = screws_[i].parent; parent >= 0) {
      carried[parent] += carried[i];
      moment[parent] += moment[i];
    }
  }
  Eigen::VectorXd torques{static_cast<Eigen::Index>(screws_.size())};
  for (std::size_t i = 0; i < screws_.size(); ++i) {
    const Eigen::Vector3d axis = posture[i].turn * screws_[i].axis, point = posture[i] * screws_[i].point;
    const bool standing = inLeg_[side][i];
    const double mass = standing ? mass_ - carried[i] : carried[i];
    const Eigen::Vector3d arm = (standing ? Eigen::Vector3d{wholeMoment - moment[i]} : moment[i]) - mass * point;
    torques[static_cast<Eigen::Index>(i)] = (standing ? gravity : -gravity) * up.dot(axis.cross(arm));
  }
  for (std::size_t i = 0; i < screws_.size(); ++i) {
    if (!drawing_.joints[i].drivenBy.empty()) {
      const auto motor = static_cast<Eigen::Index>(drawing_.joint(drawing_.joints[i].drivenBy));
      const double sum = torques[motor] + torques[static_cast<Eigen::Index>(i)];
      torques[motor] = torques[static_cast<Eigen::Index>(i)] = sum;
    }
  }
  return torques;
}

} // namespace blind
