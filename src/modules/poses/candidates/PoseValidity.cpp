#include "poses/candidates/PoseValidity.hpp"

#include "math/Polygon.hpp"

#include <algorithm>

namespace naocal {

PoseChecks::PoseChecks(const Robot& robot, const PoseOptions& options)
    : robot_{robot}, options_{options}, support_{supportSole(robot, options.supportFoot)},
      other_{otherSole(robot, options.supportFoot)}, collision_{robot, options.clearance} {}

bool PoseChecks::withinLimits(const Belief& belief, std::span<const std::size_t> joints) const {
  const Eigen::VectorXd angles = belief.values.head(static_cast<Eigen::Index>(robot_.joints.size()));
  return std::all_of(joints.begin(), joints.end(), [&](std::size_t joint) {
    const AngleRange limits = limitsAt(robot_, joint, angles);
    return belief.angle(joint) >= limits.lower + options_.limitMargin &&
           belief.angle(joint) <= limits.upper - options_.limitMargin;
  });
}

bool PoseChecks::touchesItself(const Posture& torsoFromLink) const {
  const RigidTransform soleFromOther = torsoFromLink[support_.link].inverse() * torsoFromLink[other_.link];
  Outline shadow;
  for (const Eigen::Vector2d& corner : other_.outline) {
    shadow.push_back((soleFromOther * Eigen::Vector3d{corner.x(), corner.y(), 0}).head<2>());
  }
  return !apart(support_.outline, shadow) || collision_.touches(torsoFromLink);
}

std::optional<double> PoseChecks::standing(const Belief& belief, const Posture& torsoFromLink,
                                           std::mt19937_64& random) const {
  return stands(robot_, torsoFromLink, options_.supportFoot, options_.footing)
             ? shareStanding(robot_, belief, options_.supportFoot, options_.stability, random)
             : std::nullopt;
}

} // namespace naocal
