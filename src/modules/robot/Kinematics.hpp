#pragma once

#include "math/RigidTransform.hpp"
#include "robot/ModelState.hpp"
#include "robot/Robot.hpp"

#include <Eigen/Geometry>
#include <Eigen/StdVector>
#include <vector>

namespace naocal {

/// torsoFromLink per link; only the requested links are set.
using LinkPoses = std::vector<RigidTransform>;

/// Links between the root and the given ones, without duplicates, parents first: the input of `forwardKinematics`.
std::vector<std::size_t> ancestorLinks(const Robot& robot, const std::vector<std::size_t>& links);

/// Computes `links` (parents first): torsoFromLink = torsoFromParent * T(origin) * rotation * linkStep *
/// exp([axis * angle]x), or * T(axis * angle) for a prismatic joint.
void forwardKinematics(const Robot& robot, const ModelState& modelState, const std::vector<std::size_t>& links,
                       LinkPoses& torsoFromLink);

/// Joints between the root and a link, ascending.
std::vector<std::size_t> ancestorJoints(const Robot& robot, std::size_t link);

/// Poses of all links.
LinkPoses forwardKinematics(const Robot& robot, const ModelState& modelState);

/// Poses of all links of the nominal robot at these angles (one per joint) [rad].
LinkPoses forwardKinematics(const Robot& robot, const Eigen::VectorXd& angles);

/// parentFromFrame = T(x, y, z) Rz(yaw) Ry(pitch) Rx(roll) of the six numbers x, y, z [m], roll, pitch, yaw [rad].
RigidTransform transformFromPlacement(const Eigen::Ref<const Eigen::Matrix<double, 6, 1>>& placement);
/// Its inverse: x, y, z [m], roll, pitch, yaw [rad], pitch within a quarter turn.
Eigen::Matrix<double, 6, 1> placementFromTransform(const RigidTransform& transform);

/// A motion (omega [rad], v [m]) of points: p moves by omega x p + v.
using Twist = Eigen::Matrix<double, 6, 1>;

/// Turn about an axis through a pivot.
Twist twistAbout(const Eigen::Vector3d& axis, const Eigen::Vector3d& pivot);

/// Motion of points fixed in a frame placed by (x, y, z, roll, pitch, yaw) in its parent, per unit of the placement's
/// component `number`, in the observer's frame.
Twist placementMotion(const RigidTransform& observerFromParent, const Twist& placement, std::size_t number);

/// omega x point + v.
inline Eigen::Vector3d velocityAt(const Eigen::Vector3d& point, const Twist& motion) {
  return Eigen::Vector3d{motion.head<3>()}.cross(point) + motion.tail<3>();
}

/// linkFromCamera = T(mount + dt) R(mount) Rx(rx) Ry(ry) Rz(rz); camera axes x forward, y left, z up.
RigidTransform linkFromCamera(const CameraMount& mount, const ModelState& modelState);

/// The same rotation and origin with OpenCV's axes: x right, y down, z forward.
RigidTransform linkFromOptical(const CameraMount& mount, const ModelState& modelState);

} // namespace naocal
