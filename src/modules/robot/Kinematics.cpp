#include "robot/Kinematics.hpp"

#include "math/Angles.hpp"

#include <algorithm>
#include <numeric>

namespace naocal {

namespace {

Eigen::Vector3d origin(const Link& link, const ModelState& modelState) {
  Eigen::Vector3d result = link.constant;
  for (const Link::Stretch& stretch : link.stretches) {
    result += modelState.length(stretch.length) * stretch.direction;
  }
  return result;
}

} // namespace

ModelState nominalState(const Robot& robot, const StateLayout& quantities) {
  ModelState modelState{quantities};
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    modelState.axis(joint) = robot.joints[joint].axis;
  }
  for (std::size_t length = 0; length < robot.lengths.size(); ++length) {
    modelState.length(length) = robot.lengths[length].value;
  }
  return modelState;
}

void moveToRest(const Robot& robot, ModelState& modelState) {
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const AngleRange limits = robot.joints[joint].limits;
    modelState.angle(joint) = std::clamp(robot.joints[joint].restAngle, limits.lower, limits.upper);
  }
}

std::vector<std::size_t> ancestorLinks(const Robot& robot, const std::vector<std::size_t>& links) {
  std::vector<bool> needed(robot.links.size(), false);
  for (std::size_t link : links) {
    for (std::optional<std::size_t> at = link; at; at = robot.links[*at].parent) {
      needed[*at] = true;
    }
  }
  std::vector<std::size_t> result;
  for (std::size_t link = 0; link < robot.links.size(); ++link) {
    if (needed[link]) {
      result.push_back(link);
    }
  }
  return result;
}

std::vector<std::size_t> ancestorJoints(const Robot& robot, std::size_t link) {
  std::vector<std::size_t> joints;
  for (const std::size_t at : ancestorLinks(robot, {link})) {
    if (robot.links[at].joint) {
      joints.push_back(*robot.links[at].joint);
    }
  }
  std::sort(joints.begin(), joints.end());
  return joints;
}

void forwardKinematics(const Robot& robot, const ModelState& modelState, const std::vector<std::size_t>& links,
                       LinkPoses& torsoFromLink) {
  const RigidTransform torso;
  torsoFromLink.resize(robot.links.size());
  for (std::size_t index : links) {
    const Link& link = robot.links[index];
    const RigidTransform& parent = link.parent ? torsoFromLink[*link.parent] : torso;
    RigidTransform& torsoFromThis = torsoFromLink[index];
    torsoFromThis.translation = parent * origin(link, modelState);
    torsoFromThis.rotation = parent.rotation;
    if (link.rotation) {
      torsoFromThis.rotation *= *link.rotation;
    }
    if (link.joint && modelState.layout().scene().hasLinkSteps) {
      const auto step = modelState.linkStep(*link.joint);
      torsoFromThis.translation += torsoFromThis.rotation * step.head<3>();
      torsoFromThis.rotation *= rotationX(step[3]) * rotationY(step[4]) * rotationZ(step[5]);
    }
    if (link.joint) {
      const Eigen::Vector3d motion = modelState.axis(*link.joint) * modelState.angle(*link.joint);
      if (robot.joints[*link.joint].isPrismatic) {
        torsoFromThis.translation += torsoFromThis.rotation * motion;
      } else {
        torsoFromThis.rotation *= rotationAbout(motion);
      }
    }
  }
}

LinkPoses forwardKinematics(const Robot& robot, const ModelState& modelState) {
  std::vector<std::size_t> all(robot.links.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  LinkPoses torsoFromLink;
  forwardKinematics(robot, modelState, all, torsoFromLink);
  return torsoFromLink;
}

LinkPoses forwardKinematics(const Robot& robot, const Eigen::VectorXd& angles) {
  ModelState modelState = nominalState(robot, StateLayout{robot.joints.size(), robot.lengths.size(), 0});
  modelState.values.head(angles.size()) = angles;
  return forwardKinematics(robot, modelState);
}

RigidTransform transformFromPlacement(const Eigen::Ref<const Eigen::Matrix<double, 6, 1>>& placement) {
  const auto [sr, cr] = SineCosine{placement[3]};
  const auto [sp, cp] = SineCosine{placement[4]};
  const auto [sy, cy] = SineCosine{placement[5]};
  return {Eigen::Matrix3d{{cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr},
                          {sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr},
                          {-sp, cp * sr, cp * cr}},
          placement.head<3>()};
}

Eigen::Matrix<double, 6, 1> placementFromTransform(const RigidTransform& transform) {
  const Eigen::Matrix3d& r = transform.rotation;
  const double level = std::hypot(r(0, 0), r(1, 0)), pitch = std::atan2(-r(2, 0), level);
  Eigen::Matrix<double, 6, 1> placement;
  if (level < 1e-12) { // roll and yaw turn about one axis: yaw does it
    placement << transform.translation, 0, pitch, std::atan2(-r(0, 1), r(1, 1));
    return placement;
  }
  placement << transform.translation, std::atan2(r(2, 1), r(2, 2)), pitch, std::atan2(r(1, 0), r(0, 0));
  return placement;
}

Twist twistAbout(const Eigen::Vector3d& axis, const Eigen::Vector3d& pivot) {
  Twist twist; // p moves by omega x (p - pivot) = omega x p + pivot x omega
  twist.head<3>() = axis;
  twist.tail<3>() = pivot.cross(axis);
  return twist;
}

Twist placementMotion(const RigidTransform& observerFromParent, const Twist& placement, std::size_t number) {
  Twist twist = Twist::Zero();
  if (number < 3) {
    twist.tail<3>() = observerFromParent.rotation.col(static_cast<Eigen::Index>(number));
    return twist;
  }
  // parentFromFrame = T Rz(yaw) Ry(pitch) Rx(roll)
  const double pitch = placement[4], yaw = placement[5];
  const Eigen::Vector3d axis = number == 3   ? rotationZ(yaw) * rotationY(pitch).col(0)
                               : number == 4 ? Eigen::Vector3d{-std::sin(yaw), std::cos(yaw), 0}
                                             : Eigen::Vector3d::UnitZ();
  return twistAbout(observerFromParent.rotation * axis, observerFromParent * Eigen::Vector3d{placement.head<3>()});
}

RigidTransform linkFromCamera(const CameraMount& mount, const ModelState& modelState) {
  const Eigen::Vector3d turn = modelState.mountRotation();
  return {mount.rotation * rotationX(turn.x()) * rotationY(turn.y()) * rotationZ(turn.z()),
          mount.translation + modelState.mountTranslation()};
}

RigidTransform linkFromOptical(const CameraMount& mount, const ModelState& modelState) {
  const RigidTransform camera = linkFromCamera(mount, modelState);
  RigidTransform result{Eigen::Matrix3d{}, camera.translation};
  result.rotation << -camera.rotation.col(1), -camera.rotation.col(2), camera.rotation.col(0);
  return result;
}

} // namespace naocal
