#include "poses/candidates/PoseValidity.hpp"

#include "math/Polygon.hpp"

#include <algorithm>

namespace naocal {

PoseValidity::PoseValidity(const Robot& robot, const PoseOptions& options)
    : robot_{robot}, options_{options}, support_{supportSole(robot, options.supportFoot)},
      other_{otherSole(robot, options.supportFoot)}, collision_{robot, options.clearance} {}

bool PoseValidity::isWithinLimits(const ModelState& modelState, std::span<const std::size_t> joints) const {
  const Eigen::VectorXd angles = modelState.values.head(static_cast<Eigen::Index>(robot_.joints.size()));
  return std::all_of(joints.begin(), joints.end(), [&](std::size_t joint) {
    const AngleRange limits = jointLimitsAt(robot_, joint, angles);
    return modelState.angle(joint) >= limits.lower + options_.limitMargin &&
           modelState.angle(joint) <= limits.upper - options_.limitMargin;
  });
}

bool PoseValidity::selfCollides(const LinkPoses& torsoFromLink) const {
  const RigidTransform soleFromOther = torsoFromLink[support_.link].inverse() * torsoFromLink[other_.link];
  ConvexPolygon shadow;
  for (const Eigen::Vector2d& corner : other_.outline) {
    shadow.push_back((soleFromOther * Eigen::Vector3d{corner.x(), corner.y(), 0}).head<2>());
  }
  return !areSeparated(support_.outline, shadow) || collision_.collides(torsoFromLink);
}

std::optional<double> PoseValidity::balancedFraction(const ModelState& modelState, const LinkPoses& torsoFromLink,
                                                     std::mt19937_64& random) const {
  return isBalanced(robot_, torsoFromLink, options_.supportFoot, options_.footing)
             ? naocal::balancedFraction(robot_, modelState, options_.supportFoot, options_.stability, random)
             : std::nullopt;
}

} // namespace naocal
