#include "poses/SelfCollision.hpp"

#include "geometry/Segments.hpp"

#include <algorithm>
#include <iterator>

namespace naocal {

namespace {

constexpr double nearAtRest = 0.01; // [m]

std::size_t countOfJointsBetween(const Robot& robot, std::size_t one, std::size_t other) {
  const std::vector<std::size_t> a = jointsTowards(robot, one), b = jointsTowards(robot, other);
  std::vector<std::size_t> between;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(between));
  return between.size();
}

} // namespace

SelfCollision::SelfCollision(const Robot& robot, double clearance) : robot_{robot}, clearance_{clearance} {
  Belief resting = drawnBelief(robot, Quantities{robot.joints.size(), robot.lengths.size(), 0});
  takeToRest(robot, resting);
  const Posture atRest = posture(robot, resting);
  for (std::size_t one = 0; one < robot.hull.size(); ++one) {
    for (std::size_t other = one + 1; other < robot.hull.size(); ++other) {
      if (countOfJointsBetween(robot, robot.hull[one].link, robot.hull[other].link) > 2 &&
          !near(one, other, atRest, nearAtRest)) {
        pairs_.emplace_back(one, other);
      }
    }
  }
}

bool SelfCollision::touches(const Posture& torsoFromLink) const {
  return std::any_of(pairs_.begin(), pairs_.end(),
                     [&](const auto& pair) { return near(pair.first, pair.second, torsoFromLink, clearance_); });
}

bool SelfCollision::near(std::size_t one, std::size_t other, const Posture& torsoFromLink, double gap) const {
  const Capsule &a = robot_.hull[one], &b = robot_.hull[other];
  const RigidTransform &ofA = torsoFromLink[a.link], &ofB = torsoFromLink[b.link];
  return segmentDistance(ofA * a.from, ofA * a.to, ofB * b.from, ofB * b.to) < a.radius + b.radius + gap;
}

} // namespace naocal
