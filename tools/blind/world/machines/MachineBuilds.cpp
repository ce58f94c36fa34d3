#include "world/machines/MachineBuilds.hpp"

#include <cmath>
#include <fmt/format.h>

namespace blind {

namespace {

using Eigen::Vector3d;

/// An axis of the stretched machine in the base's frame.
struct Axis {
  Vector3d direction, point; // [m]
  double kilograms;          // of the link that it moves
  double range;              // limits: plus and minus this [rad], [m]
  bool slides = false;
};

const Vector3d unitX = Vector3d::UnitX(), unitY = Vector3d::UnitY(), unitZ = Vector3d::UnitZ();

std::vector<Axis> elbowAxes(double reach, RandomStream& chance) {
  const double shoulder = chance.between(0.25, 0.4) * reach, front = chance.between(0, 0.15) * reach;
  const double upper = chance.between(0.4, 0.5) * reach, lift = chance.between(0, 0.1) * reach;
  const double fore = chance.between(0.4, 0.5) * reach, wrist = chance.between(0.08, 0.12) * reach;
  const Vector3d elbow{front, 0, shoulder + upper}, hand{front + fore, 0, shoulder + upper + lift};
  return {{unitZ, {0, 0, 0.5 * shoulder}, 12, 2.8},
          {unitY, {front, 0, shoulder}, 9, 1.6},
          {unitY, elbow, 5, 2.2},
          {unitX, elbow + Vector3d{0.4 * fore, 0, lift}, 3, 3},
          {unitY, hand, 1.5, 1.9},
          {unitX, hand + wrist * unitX, 0.8, 3}};
}

std::vector<Axis> offsetAxes(double reach, RandomStream& chance) {
  const double shoulder = chance.between(0.1, 0.2) * reach, side = chance.between(0.08, 0.15) * reach;
  const double upper = chance.between(0.4, 0.5) * reach, fore = chance.between(0.35, 0.45) * reach;
  const double small = chance.between(0.07, 0.1) * reach;
  const Vector3d elbow{upper, side, shoulder}, wrist = elbow + Vector3d{fore, 0, 0};
  return {{unitZ, {0, 0, 0.6 * shoulder}, 7, 3},
          {unitY, {0, side, shoulder}, 11, 2.4},
          {-unitY, elbow, 4, 2.4},
          {unitY, wrist, 2, 3},
          {-unitZ, wrist + Vector3d{0, small, 0}, 2, 3},
          {unitY, wrist + Vector3d{0, small, -small}, 0.6, 3}};
}

std::vector<Axis> slenderAxes(double reach, RandomStream& chance) {
  const double shoulder = chance.between(0.28, 0.36) * reach, upper = chance.between(0.35, 0.42) * reach;
  const double fore = chance.between(0.35, 0.42) * reach, bend = chance.between(0, 0.1) * reach;
  const double tip = chance.between(0.07, 0.11) * reach;
  const double elbow = shoulder + upper, wrist = elbow + fore;
  return {{unitZ, {0, 0, 0.5 * shoulder}, 4, 2.8},         {unitY, {0, 0, shoulder}, 4, 1.8},
          {unitZ, {0, 0, shoulder + 0.5 * upper}, 3, 2.8}, {-unitY, {bend, 0, elbow}, 3, 2.2},
          {unitZ, {0, 0, elbow + 0.5 * fore}, 2.5, 2.8},   {-unitY, {0, 0, wrist}, 2, 2.2},
          {unitZ, {bend, 0, wrist + tip}, 0.7, 2.9}};
}

/// Frames parallel to the base's, turned by right angles, or turned anyhow.
Eigen::Matrix3d drawFrame(int manner, RandomStream& chance) {
  constexpr double quarter = M_PI / 2;
  const auto angle = [&] { return manner == 1 ? quarter * chance.below(4) : chance.uniformWithin(M_PI); };
  return manner == 0 ? Eigen::Matrix3d::Identity()
                     : originTransform(Vector3d::Zero(), {angle(), angle(), angle()}).turn;
}

Vector3d rounded(const Vector3d& vector) {
  constexpr double digits = 1e9;
  return (vector * digits).array().round() / digits;
}

/// From the torso down the leg, then the head.
std::vector<Axis> leggedAxes(double thigh, double aside, double neck) {
  const Vector3d hip{0, aside, -0.1}, knee = hip - thigh * unitZ, ankle = knee - 0.95 * thigh * unitZ;
  return {{unitZ, hip, 0.5, 0.6},
          {unitX, hip, 0.4, 0.4},
          {unitY, hip, 2, 0.8},
          {unitY, knee, 1.5, 0.9},
          {unitY, ankle, 0.3, 0.7},
          {unitX, ankle, 0.7, 0.4},
          {unitZ, neck * unitZ, 0.3, 1.5},
          {unitY, (neck + 0.05) * unitZ, 0.8, 1}};
}

/// The joint that moves the link carrying a machine's joint.
int parentOf(MachineBuild build, std::size_t joint) {
  constexpr std::size_t neck = 6;
  return build == MachineBuild::legged && joint == neck ? -1 : static_cast<int>(joint) - 1;
}

/// A link on a joint, at a place in the frame of the stretched machine's base.
Machine::Attached attach(const std::string& link, int joint, const Transform& baseFromJoint, const Transform& place) {
  const Transform mount = baseFromJoint.inverse() * place;
  return {link, joint, rounded(mount.shift), rounded(rollPitchYaw(mount.turn))};
}

/// Gives a legged machine its torso's mass and sole, and its head's camera.
void completeLegged(Machine& machine, const std::vector<Transform>& frames, double neck) {
  constexpr std::size_t ankle = 5, head = 7;
  constexpr double soleBelow = 0.04; // [m]
  machine.baseKilograms = 6;
  machine.baseCentre = {0.01, 0, 0.1};
  const Transform sole{Eigen::Matrix3d::Identity(), frames[ankle].shift - soleBelow * unitZ};
  const Machine::Attached foot = attach("sole", ankle, frames[ankle], sole);
  machine.sole = Machine::Sole{ankle, foot.xyz, foot.rpy};
  Eigen::Matrix3d forward; // right, down and forward in the base's axes
  forward << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  const Transform camera{rotationAbout(unitY, 0.4) * forward, Vector3d{0.06, 0, neck + 0.1}};
  machine.attached.push_back(attach("hand", head, frames[head], camera));
}

} // namespace

Machine drawMachine(MachineBuild build, RandomStream& chance) {
  const double reach = chance.between(0.6, 1.1), neck = 0.3 * reach;
  std::vector<Axis> axes = build == MachineBuild::offset    ? offsetAxes(reach, chance)
                           : build == MachineBuild::slender ? slenderAxes(reach, chance)
                           : build == MachineBuild::legged  ? leggedAxes(0.2 * reach, 0.06 * reach, neck)
                                                            : elbowAxes(reach, chance);
  if (build == MachineBuild::railed) {
    axes.insert(axes.begin(), {unitY, Vector3d{0, 0, 0.05}, 15, 0.5 * reach, true});
  }
  const int manner = chance.below(3);
  Machine machine;
  machine.name = "machine";
  std::vector<Transform> frames; // baseFromJoint
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Axis& axis = axes[i];
    const Transform frame{drawFrame(manner, chance), axis.point};
    const int parent = parentOf(build, i);
    const Transform step = parent < 0 ? frame : frames[static_cast<std::size_t>(parent)].inverse() * frame;
    Machine::Joint joint;
    joint.name = fmt::format("joint{}", i + 1);
    joint.link = fmt::format("link{}", i + 1);
    joint.parent = parent;
    joint.xyz = rounded(step.shift);
    joint.rpy = rounded(rollPitchYaw(step.turn));
    joint.axis = rounded(frame.turn.transpose() * axis.direction);
    joint.slides = axis.slides;
    joint.upper = axis.range * chance.between(0.85, 1);
    joint.lower = -joint.upper;
    joint.kilograms = axis.kilograms * chance.between(0.7, 1.3);
    const bool last = i + 1 == axes.size() || parentOf(build, i + 1) != static_cast<int>(i);
    const Vector3d next = last ? axis.point + 0.05 * axis.direction : axes[i + 1].point;
    const Vector3d aside{chance.uniformWithin(0.02), chance.uniformWithin(0.02), chance.uniformWithin(0.02)};
    joint.centre = rounded(frame.turn.transpose() * (chance.between(0.3, 0.6) * (next - axis.point) + aside));
    machine.joints.push_back(std::move(joint));
    frames.push_back(frame);
  }
  if (build == MachineBuild::legged) {
    completeLegged(machine, frames, neck);
    return machine;
  }
  const Transform hand{drawFrame(manner, chance),
                       axes.back().point + chance.between(0.04, 0.09) * axes.back().direction};
  machine.attached.push_back(attach("hand", static_cast<int>(axes.size()) - 1, frames.back(), hand));
  return machine;
}

} // namespace blind
