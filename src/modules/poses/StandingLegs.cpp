#include "poses/StandingLegs.hpp"

#include "math/Angles.hpp"
#include "math/Polygon.hpp"
#include "robot/Gravity.hpp"

#include <cmath>

namespace naocal {

StandingLegs::StandingLegs(const Robot& robot, const PoseOptions& options)
    : robot_{robot}, options_{options}, other_{otherSole(robot, options.supportFoot)},
      feet_{robot, options.supportFoot}, joints_{feet_.supportLeg().joints().begin(),
                                                 feet_.supportLeg().joints().end()} {
  joints_.insert(joints_.end(), feet_.otherLeg().joints().begin(), feet_.otherLeg().joints().end());
}

std::size_t StandingLegs::ranges() const {
  return options_.supportFoot == SupportFoot::both ? 8 : 11;
}

bool StandingLegs::bend(Belief& belief, const DrawnNumber& draw) const {
  return options_.supportFoot == SupportFoot::both ? bendOnBoth(belief, draw) : bendOnOne(belief, draw);
}

bool StandingLegs::bendOnOne(Belief& belief, const DrawnNumber& draw) const {
  const double outwards = options_.supportFoot == SupportFoot::left ? 1 : -1; // the support foot's outer side
  RigidTransform soleFromTorso;
  soleFromTorso.rotation = rotationZ(draw(options_.yaw)) * rotationY(draw(options_.pitch));
  soleFromTorso.rotation *= rotationX(draw(options_.roll));
  RigidTransform soleFromOther;
  soleFromOther.rotation = rotationY(draw(options_.otherTilt));
  soleFromOther.rotation *= rotationX(draw(options_.otherTilt));
  soleFromOther.translation.x() = draw(options_.otherForwards);
  soleFromOther.translation.y() = -outwards * draw(options_.otherSideways);
  soleFromOther.translation.z() = draw(options_.otherUp);
  Eigen::Vector2d wanted = feet_.middle();
  wanted.x() += draw(options_.centreForwards);
  wanted.y() += outwards * draw(options_.centreOutwards);
  soleFromTorso.translation.z() = draw(options_.height);
  return feet_.stand(belief, soleFromTorso, soleFromOther, wanted);
}

/// One motor turns both hips, in opposite directions: the torso's yaw is sought by secants at which either leg wants it
/// to turn by as much.
bool StandingLegs::bendOnBoth(Belief& belief, const DrawnNumber& draw) const {
  const BesideFoot& beside = options_.beside;
  RigidTransform soleFromOther;
  soleFromOther.translation.x() = draw(beside.forwards);
  soleFromOther.translation.y() = -draw(beside.sideways);
  const double otherYaw = draw(beside.yaw);
  soleFromOther.rotation = rotationZ(otherYaw);
  Eigen::Matrix3d tilted = rotationY(draw(options_.pitch));
  tilted *= rotationX(draw(options_.roll));
  const Eigen::Vector2d otherMiddle = middle(other_.outline);
  Eigen::Vector2d wanted =
      (feet_.middle() + (soleFromOther * Eigen::Vector3d{otherMiddle.x(), otherMiddle.y(), 0}).head<2>()) / 2;
  wanted.x() += draw(beside.centreForwards);
  wanted.y() += draw(beside.centreSideways);
  RigidTransform soleFromTorso;
  soleFromTorso.translation << wanted, draw(options_.height);

  constexpr int leaning = 4, rounds = 12;
  constexpr double alike = 1e-10;     // [rad]
  double slope = -2 * std::sqrt(2.0); // of the gap by the yaw, for an upright torso
  double yaw = otherYaw / 2, lastYaw = 0, lastGap = 0;
  for (int round = 0; round < rounds; ++round) {
    soleFromTorso.rotation = rotationZ(yaw) * tilted;
    const RigidTransform torsoFromSole = soleFromTorso.inverse();
    const auto support = feet_.supportLeg().angles(torsoFromSole),
               other = feet_.otherLeg().angles(torsoFromSole * soleFromOther);
    if (!support || !other) {
      return false;
    }
    set(belief, *support, *other);
    const double gap = wrapped(other->front() - support->front());
    if (round < leaning) {
      lean(belief, wanted, soleFromTorso);
    } else if (std::abs(gap) < alike) {
      belief.angle(feet_.otherLeg().joints().front()) = support->front();
      return true;
    } else if (round > leaning) {
      slope = (gap - lastGap) / (yaw - lastYaw);
    }
    lastYaw = yaw;
    lastGap = gap;
    yaw -= gap / slope;
  }
  return false;
}

void StandingLegs::set(Belief& belief, const LegAngles& support, const LegAngles& other) const {
  for (std::size_t i = 0; i < support.size(); ++i) {
    belief.angle(feet_.supportLeg().joints()[i]) = support[i];
    belief.angle(feet_.otherLeg().joints()[i]) = other[i];
  }
}

void StandingLegs::lean(const Belief& belief, const Eigen::Vector2d& wanted, RigidTransform& soleFromTorso) const {
  const Eigen::Vector3d centre = soleFromTorso * centreOfMass(robot_, posture(robot_, belief)).inTorso;
  soleFromTorso.translation.head<2>() += wanted - centre.head<2>();
}

} // namespace naocal
