#include "robot/SelfCollision.hpp"

#include <algorithm>
#include <iterator>

namespace naocal {

double segmentDistance(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r,
                       const Eigen::Vector3d& s) {
  const Eigen::Vector3d along = q - p, other = s - r, between = p - r;
  const double a = along.squaredNorm(), e = other.squaredNorm(), b = along.dot(other);
  const double c = along.dot(between), f = other.dot(between);
  const auto clamped = [](double numerator, double denominator) {
    return denominator > 0 ? std::clamp(numerator / denominator, 0.0, 1.0) : 0.0;
  };
  // Nearest point on p..q to the other line, the nearest to it on r..s, then back in case it was clamped at an end.
  double onFirst = clamped(b * f - c * e, a * e - b * b);
  const double onOther = clamped(b * onFirst + f, e);
  onFirst = clamped(b * onOther - c, a);
  return (p + onFirst * along - r - onOther * other).norm();
}

namespace {

constexpr double nearAtRest = 0.01; // [m]

std::size_t countOfJointsBetween(const Robot& robot, std::size_t one, std::size_t other) {
  const std::vector<std::size_t> a = ancestorJoints(robot, one), b = ancestorJoints(robot, other);
  std::vector<std::size_t> between;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(between));
  return between.size();
}

} // namespace

SelfCollision::SelfCollision(const Robot& robot, double clearance) : robot_{robot}, clearance_{clearance} {
  ModelState resting = nominalState(robot, StateLayout{robot.joints.size(), robot.lengths.size(), 0});
  moveToRest(robot, resting);
  const LinkPoses atRest = forwardKinematics(robot, resting);
  for (std::size_t one = 0; one < robot.collisionCapsules.size(); ++one) {
    for (std::size_t other = one + 1; other < robot.collisionCapsules.size(); ++other) {
      if (countOfJointsBetween(robot, robot.collisionCapsules[one].link, robot.collisionCapsules[other].link) > 2 &&
          !areNear(one, other, atRest, nearAtRest)) {
        pairs_.emplace_back(one, other);
      }
    }
  }
}

bool SelfCollision::collides(const LinkPoses& torsoFromLink) const {
  return std::any_of(pairs_.begin(), pairs_.end(),
                     [&](const auto& pair) { return areNear(pair.first, pair.second, torsoFromLink, clearance_); });
}

bool SelfCollision::areNear(std::size_t one, std::size_t other, const LinkPoses& torsoFromLink, double gap) const {
  const Capsule &a = robot_.collisionCapsules[one], &b = robot_.collisionCapsules[other];
  const RigidTransform &ofA = torsoFromLink[a.link], &ofB = torsoFromLink[b.link];
  return segmentDistance(ofA * a.from, ofA * a.to, ofB * b.from, ofB * b.to) < a.radius + b.radius + gap;
}

} // namespace naocal
