#include "simulation/RobotErrors.hpp"

#include "effects/Catalogue.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace naocal {

namespace {

constexpr double gapFriction = 0.3; // of a gear whose play the load can take up [Nm]

} // namespace

InjectedEffect InjectedEffect::scaledBy(double factor) const {
  InjectedEffect result = *this;
  result.compliance *= factor;
  result.play *= factor;
  result.excess *= factor;
  return result;
}

Eigen::VectorXd InjectedEffect::lag(const Eigen::VectorXd& lastMotion, const Eigen::VectorXd& torques) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(lastMotion.size());
  if (looseJoint) {
    const auto joint = static_cast<Eigen::Index>(*looseJoint);
    const bool byLoad = std::abs(torques[joint]) > friction;
    result[joint] = play / 2 * (byLoad ? std::copysign(1, torques[joint]) : -lastMotion[joint]);
  }
  return result;
}

Robot InjectedEffect::applyTo(Robot drawing) const {
  if (longBone) {
    drawing.lengths[*longBone].value += excess;
  }
  return drawing;
}

TrueEffect InjectedEffect::truth(const Robot& drawing) const {
  if (softJoint) {
    return {effectName::elasticity, drawing.joints[*softJoint].name, {{"c", compliance, "rad/Nm"}}};
  }
  if (looseJoint && std::isfinite(friction)) {
    return {effectName::gearPlay,
            drawing.joints[*looseJoint].name,
            {{"D", play, "rad"}, {"t", friction - gearFriction, "Nm"}}};
  }
  if (looseJoint) {
    return {effectName::hysteresis, drawing.joints[*looseJoint].name, {{"D", play, "rad"}}};
  }
  return {"linkLength", drawing.lengths[longBone.value()].name, {{"dL", excess, "m"}}};
}

InjectedEffect drawInjectedEffect(const Robot& drawing, SupportFoot supportFoot, RandomStream& chance) {
  const std::string side = supportFoot == SupportFoot::right ? "R" : "L";
  InjectedEffect flaw;
  switch (chance.uniformBelow(3)) {
  case 0: {
    const std::array<const char*, 2> soft{"KneePitch", "AnklePitch"};
    flaw.softJoint = drawing.jointIndex(side + soft[chance.uniformBelow(soft.size())]);
    flaw.compliance = 0.008 + chance.uniformWithin(0.002);
    break;
  }
  case 1: {
    const std::array<const char*, 4> loose{"KneePitch", "AnklePitch", "HipRoll", "HipPitch"};
    flaw.looseJoint = drawing.jointIndex(side + loose[chance.uniformBelow(loose.size())]);
    flaw.play = radians(0.7) + chance.uniformWithin(radians(0.2));
    break;
  }
  default: {
    const std::string bone = chance.bernoulli(0.5) ? "thigh" : "tibia";
    for (std::size_t length = 0; length < drawing.lengths.size(); ++length) {
      if (drawing.lengths[length].name == bone) {
        flaw.longBone = length;
      }
    }
    flaw.excess = (chance.bernoulli(0.5) ? 1 : -1) * (0.004 + chance.uniformWithin(0.001));
  }
  }
  return flaw;
}

InjectedEffect namedFlaw(const Robot& drawing, const std::string& label) {
  const std::size_t split = std::min(label.find('@'), label.size());
  const std::string effect = label.substr(0, split), place = label.substr(std::min(split + 1, label.size()));
  InjectedEffect flaw;
  if (const auto joint = drawing.jointIndex(place)) {
    const std::size_t motor = drawing.joints[*joint].motor;
    if (effect == effectName::elasticity || effect == effectName::spring) {
      flaw.softJoint = motor;
      flaw.compliance = 0.008;
    } else if (effect == effectName::hysteresis || effect == effectName::gearPlay) {
      flaw.looseJoint = motor;
      flaw.play = radians(0.7);
      flaw.friction = effect == effectName::gearPlay ? gapFriction : flaw.friction;
    }
  }
  for (std::size_t length = 0; length < drawing.lengths.size() && effect == "linkLength"; ++length) {
    if (drawing.lengths[length].name == place) {
      flaw.longBone = length;
      flaw.excess = 0.004;
    }
  }
  if (!flaw.softJoint && !flaw.looseJoint && !flaw.longBone) {
    throw InputError{fmt::format("expected elasticity, spring, hysteresis or gearPlay at a joint, or linkLength at a "
                                 "length, such as gearPlay@LKneePitch, found {}",
                                 label)};
  }
  return flaw;
}

RobotErrors drawErrors(const Robot& drawing, double offsetRange, double mountRange, double mountShiftRange,
                       RandomStream& chance) {
  RobotErrors errors;
  errors.jointOffsets.resize(static_cast<Eigen::Index>(drawing.joints.size()));
  for (double& offset : errors.jointOffsets) {
    offset = chance.uniformWithin(offsetRange);
  }
  for (std::size_t joint = 0; joint < drawing.joints.size(); ++joint) {
    errors.jointOffsets[static_cast<Eigen::Index>(joint)] =
        errors.jointOffsets[static_cast<Eigen::Index>(drawing.joints[joint].motor)];
  }
  for (std::size_t camera = 0; camera < drawing.cameras.size(); ++camera) {
    RobotErrors::Mount& mount = errors.mounts.emplace_back();
    for (int axis = 0; axis < 3; ++axis) {
      mount.rotation[axis] = chance.uniformWithin(mountRange);
      mount.translation[axis] = chance.uniformWithin(mountShiftRange);
    }
  }
  return errors;
}

std::vector<TrueEffect> listTrueEffects(const Robot& drawing, const RobotErrors& errors) {
  std::vector<TrueEffect> effects;
  for (std::size_t joint = 0; joint < drawing.joints.size(); ++joint) {
    if (drawing.joints[joint].motor == joint) {
      const double offset = errors.jointOffsets[static_cast<Eigen::Index>(joint)];
      effects.push_back({effectName::jointOffset, drawing.joints[joint].name, {{"o", offset, "rad"}}});
    }
  }
  for (std::size_t camera = 0; camera < drawing.cameras.size(); ++camera) {
    const std::string& name = drawing.cameras[camera].name;
    const auto& [turn, shift] = errors.mounts[camera];
    effects.push_back({effectName::cameraRotation,
                       name,
                       {{"rx", turn.x(), "rad"}, {"ry", turn.y(), "rad"}, {"rz", turn.z(), "rad"}}});
    if (shift != Eigen::Vector3d::Zero()) {
      effects.push_back(
          {"cameraTranslation", name, {{"x", shift.x(), "m"}, {"y", shift.y(), "m"}, {"z", shift.z(), "m"}}});
    }
  }
  if (errors.flaw) {
    effects.push_back(errors.flaw->truth(drawing));
  }
  return effects;
}

} // namespace naocal
