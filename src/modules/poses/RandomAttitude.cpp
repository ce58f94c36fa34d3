#include "poses/RandomAttitude.hpp"

#include "model/Masses.hpp"
#include "poses/Outline.hpp"

#include <algorithm>
#include <numeric>
#include <set>

namespace naocal {

namespace {

std::vector<std::size_t> headJoints(const Robot& robot) {
  std::set<std::size_t> joints;
  for (const CameraMount& camera : robot.cameras) {
    for (std::optional<std::size_t> link = camera.link; link; link = robot.links[*link].parent) {
      if (robot.links[*link].joint) {
        joints.insert(*robot.links[*link].joint);
      }
    }
  }
  return {joints.begin(), joints.end()};
}

Eigen::Vector2d middle(const Outline& outline) {
  const Eigen::Vector2d sum = std::accumulate(outline.begin(), outline.end(), Eigen::Vector2d::Zero().eval());
  return sum / static_cast<double>(outline.size());
}

} // namespace

RandomAttitude::RandomAttitude(const Robot& robot, const Scene& scene, const PoseOptions& options)
    : robot_{robot}, scene_{scene}, options_{options}, support_{supportSole(robot, options.supportFoot)},
      other_{otherSole(robot, options.supportFoot)}, supportLeg_{robot, support_.name}, otherLeg_{robot, other_.name},
      head_{headJoints(robot)}, hanging_{scene.drawn()}, random_{options.seed} {
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const AngleRange limits = robot.joints[joint].limits;
    hanging_.angle(joint) = std::clamp(robot.joints[joint].resting, limits.lower, limits.upper);
  }
}

std::optional<Belief> RandomAttitude::draw() {
  Belief belief = hanging_;
  if (!standUp(belief) || !lookAround(belief)) {
    return std::nullopt;
  }
  const Posture torsoFromLink = posture(robot_, belief);
  if (!stands(robot_, torsoFromLink, support_, other_, options_.footing) || !solesApart(torsoFromLink) ||
      !standsDespiteErrors(robot_, belief, support_, other_, options_.stability, random_)) {
    return std::nullopt;
  }
  return belief;
}

bool RandomAttitude::standUp(Belief& belief) {
  const double outwards = options_.supportFoot == SupportFoot::left ? 1 : -1; // the support foot's outer side
  RigidTransform soleFromTorso;
  soleFromTorso.rotation = rotationZ(from(options_.yaw)) * rotationY(from(options_.pitch));
  soleFromTorso.rotation *= rotationX(from(options_.roll));
  RigidTransform soleFromOther;
  soleFromOther.rotation = rotationY(from(options_.otherTilt));
  soleFromOther.rotation *= rotationX(from(options_.otherTilt));
  soleFromOther.translation.x() = from(options_.otherForwards);
  soleFromOther.translation.y() = -outwards * from(options_.otherSideways);
  soleFromOther.translation.z() = from(options_.otherUp);
  Eigen::Vector2d wanted = middle(support_.outline);
  wanted.x() += from(options_.centreForwards);
  wanted.y() += outwards * from(options_.centreOutwards);
  soleFromTorso.translation << wanted, from(options_.height);

  constexpr int rounds = 3; // each leaves a small share of the distance
  for (int round = 0; round < rounds; ++round) {
    if (!bendLegs(belief, soleFromTorso, soleFromOther)) {
      return false;
    }
    const Eigen::Vector3d centre = soleFromTorso * centreOfMass(robot_, posture(robot_, belief)).inTorso;
    soleFromTorso.translation.head<2>() += wanted - centre.head<2>();
  }
  return bendLegs(belief, soleFromTorso, soleFromOther) && withinLimits(belief, supportLeg_.joints()) &&
         withinLimits(belief, otherLeg_.joints());
}

bool RandomAttitude::bendLegs(Belief& belief, const RigidTransform& soleFromTorso,
                              const RigidTransform& soleFromOther) const {
  const RigidTransform torsoFromSole = soleFromTorso.inverse();
  const auto support = supportLeg_.angles(torsoFromSole);
  const auto other = support ? otherLeg_.angles(torsoFromSole * soleFromOther, support->front()) : std::nullopt;
  if (!other) {
    return false;
  }
  for (std::size_t i = 0; i < support->size(); ++i) {
    belief.angle(supportLeg_.joints()[i]) = (*support)[i];
    belief.angle(otherLeg_.joints()[i]) = (*other)[i];
  }
  return true;
}

bool RandomAttitude::lookAround(Belief& belief) {
  constexpr int glances = 30;
  for (int glance = 0; glance < glances; ++glance) {
    for (const std::size_t joint : head_) {
      belief.angle(joint) = from({robot_.joints[joint].limits.lower, robot_.joints[joint].limits.upper});
    }
    if (withinLimits(belief, head_) && !scene_.sights(belief, posture(robot_, belief)).empty()) {
      return true;
    }
  }
  return false;
}

template <typename Joints> bool RandomAttitude::withinLimits(const Belief& belief, const Joints& joints) const {
  const Eigen::VectorXd angles = belief.values.head(static_cast<Eigen::Index>(robot_.joints.size()));
  return std::all_of(joints.begin(), joints.end(), [&](std::size_t joint) {
    const AngleRange limits = limitsAt(robot_, joint, angles);
    return belief.angle(joint) >= limits.lower + options_.limitMargin &&
           belief.angle(joint) <= limits.upper - options_.limitMargin;
  });
}

bool RandomAttitude::solesApart(const Posture& torsoFromLink) const {
  const RigidTransform soleFromOther = torsoFromLink[support_.link].inverse() * torsoFromLink[other_.link];
  Outline shadow;
  for (const Eigen::Vector2d& corner : other_.outline) {
    shadow.push_back((soleFromOther * Eigen::Vector3d{corner.x(), corner.y(), 0}).head<2>());
  }
  return apart(support_.outline, shadow);
}

double RandomAttitude::from(const Interval& interval) {
  return std::uniform_real_distribution{interval.lower, interval.upper}(random_);
}

} // namespace naocal
