#include "robot/LegKinematics.hpp"

#include "io/InputError.hpp"
#include "math/Angles.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace naocal {

namespace {

/// Angle of (x, z) about y [rad]: Ry(a) increases it by a.
double angleAboutY(const Eigen::Vector3d& v) {
  return std::atan2(v.x(), v.z());
}

/// Roll about x in [-pi/2, pi/2] that rotates a vector into the xz-plane: Rx(a) v has no y component.
double rollIntoPlane(const Eigen::Vector3d& v) {
  return v.z() < 0 ? std::atan2(-v.y(), -v.z()) : std::atan2(v.y(), v.z());
}

Eigen::Vector3d nominalOrigin(const Robot& robot, const Link& link) {
  Eigen::Vector3d origin = link.constant;
  for (const Link::Stretch& stretch : link.stretches) {
    origin += robot.lengths[stretch.length].value * stretch.direction;
  }
  return origin;
}

} // namespace

LegKinematics::LegKinematics(const Robot& robot, std::string_view side) {
  const auto require = [&](bool met, std::string_view expected) {
    if (!met) {
      throw InputError{fmt::format("the drawing of {}: {} leg: expected {}, found another build; this leg's angles can "
                                   "not be computed in closed form",
                                   robot.model, side, expected)};
    }
  };
  const Sole* sole = robot.findSole(side);
  require(sole != nullptr, "a sole of that name");
  // Links from root to sole: hip yaw-pitch, hip roll, hip pitch, knee, ankle pitch, ankle roll, sole.
  std::array<const Link*, 7> links{};
  std::optional<std::size_t> at = sole->link;
  for (std::size_t i = links.size(); i-- > 0; at = robot.links[*at].parent) {
    require(robot.links[*at].parent.has_value(), "six joints between the root and the sole");
    links[i] = &robot.links[*at];
  }
  require(!robot.links[*at].parent && !links[6]->joint, "six joints between the root and the sole");
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY();
  const std::array<Eigen::Vector3d, 5> axes{x, y, y, y, x};
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    require(links[i]->joint.has_value(), "six joints between the root and the sole");
    joints_[i] = *links[i]->joint;
    require(i == 0 || robot.joints[joints_[i]].axis == axes[i - 1], "axes x, y, y, y, x after hip yaw-pitch");
  }
  yawPitchAxis_ = robot.joints[joints_[0]].axis;
  require(yawPitchAxis_.x() == 0, "a hip yaw-pitch axis at a right angle to x");
  hip_ = nominalOrigin(robot, *links[0]);
  thigh_ = -nominalOrigin(robot, *links[3]).z();
  tibia_ = -nominalOrigin(robot, *links[4]).z();
  footHeight_ = -nominalOrigin(robot, *links[6]).z();
  const std::array<double, 6> drops{0, 0, thigh_, tibia_, 0, footHeight_};
  for (std::size_t i = 0; i < drops.size(); ++i) {
    require(nominalOrigin(robot, *links[i + 1]) == Eigen::Vector3d{0, 0, -drops[i]},
            "hip, knee, ankle and sole in a line");
  }
}

std::optional<double> LegKinematics::solveKnee(double distance) const {
  constexpr double roundOff = 1e-12; // a straight leg is within reach, although its cosine may exceed 1 by rounding
  const double cosine = (distance * distance - thigh_ * thigh_ - tibia_ * tibia_) / (2 * thigh_ * tibia_);
  if (std::abs(cosine) > 1 + roundOff) {
    return std::nullopt;
  }
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

std::optional<LegAngles> LegKinematics::solveAngles(const RigidTransform& torsoFromSole) const {
  // Hip in the sole frame: the ankle roll rotates it into the plane of the leg, the ankle pitch onto the leg.
  const Eigen::Vector3d hipInSole = torsoFromSole.inverse() * hip_;
  const Eigen::Vector3d hipInFoot = hipInSole - Eigen::Vector3d{0, 0, footHeight_};
  const auto kneePitch = solveKnee(hipInFoot.norm());
  if (!kneePitch) {
    return std::nullopt;
  }
  const double ankleRoll = rollIntoPlane(hipInFoot);
  const Eigen::Vector3d hipFromAnkle{-thigh_ * std::sin(*kneePitch), 0, tibia_ + thigh_ * std::cos(*kneePitch)};
  const double anklePitch = wrapAngle(angleAboutY(hipFromAnkle) - angleAboutY(rotationX(ankleRoll) * hipInFoot));

  // The remainder is R(axis, yawPitch) Rx(hipRoll) Ry(hipPitch); with axis = Rx(tilt) y it equals Rx(tilt) Ry(yawPitch)
  // Rx(hipRoll - tilt) Ry(hipPitch). Selects the hip roll on the same side of the tilt as 0.
  const double tilt = std::atan2(yawPitchAxis_.z(), yawPitchAxis_.y());
  const double side = tilt < 0 ? 1 : -1;
  const Eigen::Matrix3d turn =
      rotationX(-tilt) * torsoFromSole.rotation * rotationX(-ankleRoll) * rotationY(-anklePitch - *kneePitch);
  const double roll = side * std::atan2(std::hypot(turn(0, 1), turn(2, 1)), turn(1, 1));
  const double yawPitch = std::atan2(side * turn(0, 1), side * turn(2, 1));
  const Eigen::Matrix3d rest = rotationX(-roll) * rotationY(-yawPitch) * turn;
  const double hipPitch = std::atan2(rest(0, 2), rest(0, 0));
  return LegAngles{yawPitch, wrapAngle(roll + tilt), hipPitch, *kneePitch, anklePitch, ankleRoll};
}

std::optional<LegAngles> LegKinematics::solveAngles(const RigidTransform& torsoFromSole, double hipYawPitch) const {
  // The sole's origin and z axis determine the ankle; hip roll, hip pitch and knee reach it; the ankle orients z.
  const Eigen::Vector3d up = torsoFromSole.rotation.col(2);
  const Eigen::Matrix3d torsoFromPelvis = rotationAbout(hipYawPitch * yawPitchAxis_);
  const Eigen::Vector3d ankleFromHip = torsoFromSole.translation + footHeight_ * up - hip_;
  const Eigen::Vector3d ankleInPelvis = torsoFromPelvis.transpose() * ankleFromHip;
  const auto kneePitch = solveKnee(ankleInPelvis.norm());
  if (!kneePitch) {
    return std::nullopt;
  }
  const double hipRoll = -rollIntoPlane(ankleInPelvis);
  const Eigen::Vector3d ankleInThigh{-tibia_ * std::sin(*kneePitch), 0, -thigh_ - tibia_ * std::cos(*kneePitch)};
  const double hipPitch = wrapAngle(angleAboutY(rotationX(-hipRoll) * ankleInPelvis) - angleAboutY(ankleInThigh));
  const Eigen::Vector3d upInTibia =
      rotationY(-hipPitch - *kneePitch) * rotationX(-hipRoll) * torsoFromPelvis.transpose() * up;
  const double ankleRoll = std::asin(std::clamp(-upInTibia.y(), -1.0, 1.0));
  return LegAngles{hipYawPitch, hipRoll, hipPitch, *kneePitch, angleAboutY(upInTibia), ankleRoll};
}

bool hasPlannableLegs(const Robot& robot) {
  try {
    for (const char* const side : {"left", "right"}) {
      LegKinematics{robot, side};
    }
  } catch (const InputError&) { // legs of another build
    return false;
  }
  return true;
}

} // namespace naocal
