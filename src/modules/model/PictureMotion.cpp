#include "model/Picture.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace naocal {

namespace {

using Twist = Eigen::Matrix<double, 6, 1>;

inline Twist turnAbout(const Eigen::Vector3d& axisInOptical, const Eigen::Vector3d& pivotInOptical) {
  Twist twist; // p moves by omega x (p - pivot) = omega x p + pivot x omega
  twist.head<3>() = axisInOptical;
  twist.tail<3>() = pivotInOptical.cross(axisInOptical);
  return twist;
}

/// A frame placed by (x, y, z, roll, pitch, yaw) moves, and what is fixed in it, by the placement's n-th number.
Twist placementMotion(const RigidTransform& opticalFromParent, const Twist& placement, std::size_t number) {
  Twist twist = Twist::Zero();
  if (number < 3) {
    twist.tail<3>() = opticalFromParent.rotation.col(static_cast<Eigen::Index>(number));
    return twist;
  }
  // parentFromFrame = T Rz(yaw) Ry(pitch) Rx(roll)
  const double pitch = placement[4], yaw = placement[5];
  const Eigen::Vector3d axis = number == 3   ? rotationZ(yaw) * rotationY(pitch).col(0)
                               : number == 4 ? Eigen::Vector3d{-std::sin(yaw), std::cos(yaw), 0}
                                             : Eigen::Vector3d::UnitZ();
  return turnAbout(opticalFromParent.rotation * axis, opticalFromParent * Eigen::Vector3d{placement.head<3>()});
}

} // namespace

/// Angles, axes and lengths: what lies beyond the link moves; a link that carries the camera moves the scene backwards.
View::Twist View::linkMotion(const Robot& robot, const Attitude& attitude, const Belief& belief,
                             const Posture& torsoFromLink, std::size_t quantity) const {
  if (quantity >= quantities_.length(0)) {
    Twist sum = Twist::Zero();
    const std::size_t length = quantity - quantities_.length(0);
    for (std::size_t index : links_) {
      const Link& link = robot.links[index];
      for (const Link::Stretch& stretch : link.stretches) {
        if (stretch.length == length && link.parent) {
          sum.tail<3>() += side_[index] * (attitude.opticalFromTorso.rotation *
                                           (torsoFromLink[*link.parent].rotation * stretch.direction));
        }
      }
    }
    return sum;
  }
  const bool isAngle = quantity < quantities_.axis(0);
  const std::size_t joint = isAngle ? quantity : (quantity - quantities_.axis(0)) / 3;
  const std::size_t link = robot.joints[joint].link;
  if (side_[link] == 0) {
    return Twist::Zero();
  }
  const RigidTransform& torsoFromThis = torsoFromLink[link];
  Eigen::Vector3d turn = belief.axis(joint);
  if (!isAngle) {
    // exp([a q]x) with a -> a + da turns by J_l(a q) q da; seen from behind the rotation, by its transpose.
    const auto component = static_cast<Eigen::Index>((quantity - quantities_.axis(0)) % 3);
    const double angle = belief.angle(joint);
    turn = angle * leftJacobian(belief.axis(joint) * angle).row(component).transpose();
  }
  const Eigen::Vector3d turnInTorso = torsoFromThis.rotation * (side_[link] * turn);
  return turnAbout(attitude.opticalFromTorso.rotation * turnInTorso,
                   attitude.opticalFromTorso * torsoFromThis.translation);
}

/// The camera itself moves in its link: the scene moves the other way.
View::Twist View::mountMotion(const Robot& robot, const Belief& belief, std::size_t number) const {
  const CameraMount& mount = robot.cameras[*camera_];
  const Eigen::Matrix3d opticalFromLink = linkFromOptical(mount, belief).rotation.transpose();
  Twist twist = Twist::Zero();
  if (number < 3) {
    twist.tail<3>() = -opticalFromLink.col(static_cast<Eigen::Index>(number));
    return twist;
  }
  // linkFromCamera = Ry(pitch) Rx(rx) Ry(ry) Rz(rz)
  const Eigen::Vector3d turn = belief.mountRotation();
  Eigen::Matrix3d before = rotationY(mount.pitch);
  if (number > 3) {
    before = before * rotationX(turn.x());
  }
  if (number > 4) {
    before = before * rotationY(turn.y());
  }
  twist.head<3>() = -opticalFromLink * before.col(static_cast<Eigen::Index>(number - 3));
  return twist;
}

void View::setDrift(const Robot& robot, const Belief& belief, const Posture& torsoFromLink,
                    const Eigen::VectorXd& velocity, Attitude& attitude) const {
  attitude.drift.setZero();
  for (const std::size_t joint : joints_) {
    attitude.drift += velocity[static_cast<Eigen::Index>(joint)] *
                      linkMotion(robot, attitude, belief, torsoFromLink, quantities_.angle(joint));
  }
}

void View::motion(const Robot& robot, const Attitude& attitude, const Belief& belief, const Posture& torsoFromLink,
                  const std::vector<std::size_t>& wanted, const std::vector<std::size_t>& extras,
                  Eigen::Ref<Eigen::MatrixXd> columns) const {
  columns.setZero();
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const std::size_t quantity = wanted[i];
    auto column = columns.col(static_cast<Eigen::Index>(i));
    if (quantity < quantities_.mountTranslation()) {
      column.head<6>() = linkMotion(robot, attitude, belief, torsoFromLink, quantity);
    } else if (quantity < quantities_.lens() && camera_) {
      column.head<6>() = mountMotion(robot, belief, quantity - quantities_.mountTranslation());
    } else if (const auto number = camera_ ? extra(quantity) : std::nullopt) {
      const auto row = std::find(extras.begin(), extras.end(), *number);
      assert(row != extras.end());
      column[6 + (row - extras.begin())] = 1;
    } else if (quantity >= quantities_.ground() && quantity < quantities_.ground() + 6 && onFloor_) {
      // the sole moves in the world, hence the world backwards in the sole
      column.head<6>() = -placementMotion(attitude.opticalFromWorld, belief.ground(), quantity - quantities_.ground());
    } else if (camera_ && quantity >= quantities_.board(board_) && quantity < quantities_.board(board_) + 6) {
      column.head<6>() = placementMotion(onFloor_ ? attitude.opticalFromWorld : attitude.opticalFromTarget,
                                         belief.boardPlacement(board_), quantity - quantities_.board(board_));
    }
  }
}

} // namespace naocal
