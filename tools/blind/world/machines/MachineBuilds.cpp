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

} // namespace

Machine drawMachine(MachineBuild build, RandomStream& chance) {
  const double reach = chance.between(0.6, 1.1);
  std::vector<Axis> axes = build == MachineBuild::offset    ? offsetAxes(reach, chance)
                           : build == MachineBuild::slender ? slenderAxes(reach, chance)
                                                            : elbowAxes(reach, chance);
  if (build == MachineBuild::railed) {
    axes.insert(axes.begin(), {unitY, Vector3d{0, 0, 0.05}, 15, 0.5 * reach, true});
  }
  const int manner = chance.below(3);
  Machine machine;
  machine.name = "machine";
  Transform parent; // baseFromJoint of the joint before
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Axis& axis = axes[i];
    Transform frame{drawFrame(manner, chance), axis.point};
    const Transform step = parent.inverse() * frame;
    Machine::Joint joint;
    joint.name = fmt::format("joint{}", i + 1);
    joint.link = fmt::format("link{}", i + 1);
    joint.parent = static_cast<int>(i) - 1;
    joint.xyz = rounded(step.shift);
    joint.rpy = rounded(rollPitchYaw(step.turn));
    joint.axis = rounded(frame.turn.transpose() * axis.direction);
    joint.slides = axis.slides;
    joint.upper = axis.range * chance.between(0.85, 1);
    joint.lower = -joint.upper;
    joint.kilograms = axis.kilograms * chance.between(0.7, 1.3);
    const Vector3d next = i + 1 < axes.size() ? axes[i + 1].point : axis.point + 0.05 * axis.direction;
    const Vector3d aside{chance.uniformWithin(0.02), chance.uniformWithin(0.02), chance.uniformWithin(0.02)};
    joint.centre = rounded(frame.turn.transpose() * (chance.between(0.3, 0.6) * (next - axis.point) + aside));
    machine.joints.push_back(std::move(joint));
    parent = frame;
  }
  const Transform hand{drawFrame(manner, chance),
                       axes.back().point + chance.between(0.04, 0.09) * axes.back().direction};
  const Transform mount = parent.inverse() * hand;
  machine.attached.push_back(
      {"hand", static_cast<int>(axes.size()) - 1, rounded(mount.shift), rounded(rollPitchYaw(mount.turn))});
  return machine;
}

} // namespace blind
