#include "robot/UrdfShapes.hpp"

#include "math/RigidTransform.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <urdf_model/link.h>

namespace naocal {

namespace {

/// A capsule along an axis of the shape's frame, `beside` it.
Capsule capsuleAlong(const Eigen::Vector3d& axis, double halfLength, double radius,
                     const Eigen::Vector3d& beside = Eigen::Vector3d::Zero()) {
  return {.link = 0, .from = beside - halfLength * axis, .to = beside + halfLength * axis, .radius = radius};
}

/// Capsules along the longest edge, in a row along the second one.
std::vector<Capsule> fillBox(const Eigen::Vector3d& edges) {
  constexpr double most = 16; // of one box
  Eigen::Index longest = 0, shortest = 0;
  edges.maxCoeff(&longest);
  edges.minCoeff(&shortest);
  shortest = shortest == longest ? (longest + 1) % 3 : shortest; // a cube
  const Eigen::Index middle = 3 - longest - shortest;
  const double radius = edges[shortest] / 2, width = edges[middle] / 2 - radius;
  const int count = static_cast<int>(std::clamp(std::ceil(width / radius) + 1, 1.0, most));
  std::vector<Capsule> capsules;
  for (int i = 0; i < count; ++i) {
    const double at = count == 1 ? 0 : width * (2.0 * i / (count - 1) - 1);
    capsules.push_back(capsuleAlong(Eigen::Vector3d::Unit(longest), edges[longest] / 2 - radius, radius,
                                    at * Eigen::Vector3d::Unit(middle)));
  }
  return capsules;
}

/// In the shape's own frame.
std::vector<Capsule> fillShape(const urdf::Geometry& geometry) {
  const auto isSize = [](double size) { return std::isfinite(size) && size > 0; };
  if (const auto* const sphere = dynamic_cast<const urdf::Sphere*>(&geometry); sphere && isSize(sphere->radius)) {
    return {capsuleAlong(Eigen::Vector3d::UnitZ(), 0, sphere->radius)};
  }
  if (const auto* const cylinder = dynamic_cast<const urdf::Cylinder*>(&geometry);
      cylinder && isSize(cylinder->radius) && isSize(cylinder->length)) {
    return {capsuleAlong(Eigen::Vector3d::UnitZ(), std::max(0.0, cylinder->length / 2 - cylinder->radius),
                         cylinder->radius)};
  }
  if (const auto* const box = dynamic_cast<const urdf::Box*>(&geometry);
      box && isSize(box->dim.x) && isSize(box->dim.y) && isSize(box->dim.z)) {
    return fillBox({box->dim.x, box->dim.y, box->dim.z});
  }
  return {};
}

} // namespace

std::vector<Capsule> makeCapsules(const urdf::Link& drawn, std::size_t link) {
  std::vector<Capsule> capsules;
  for (const urdf::CollisionSharedPtr& collision : drawn.collision_array) {
    if (!collision || !collision->geometry) {
      continue;
    }
    const urdf::Pose& pose = collision->origin;
    Eigen::Quaterniond turn{pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z};
    const RigidTransform linkFromShape{turn.norm() > 0 ? Eigen::Matrix3d{turn.normalized().toRotationMatrix()}
                                                       : Eigen::Matrix3d::Identity(),
                                       {pose.position.x, pose.position.y, pose.position.z}};
    for (Capsule& capsule : fillShape(*collision->geometry)) {
      capsules.push_back({.link = link,
                          .from = linkFromShape * capsule.from,
                          .to = linkFromShape * capsule.to,
                          .radius = capsule.radius});
    }
  }
  return capsules;
}

} // namespace naocal
