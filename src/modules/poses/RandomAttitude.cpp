#include "poses/RandomAttitude.hpp"

#include <set>

namespace naocal {

namespace {

std::vector<std::size_t> headJoints(const Robot& robot) {
  std::set<std::size_t> joints;
  for (const CameraMount& camera : robot.cameras) {
    const std::vector<std::size_t> ofCamera = jointsTowards(robot, camera.link);
    joints.insert(ofCamera.begin(), ofCamera.end());
  }
  return {joints.begin(), joints.end()};
}

} // namespace

Sieve& Sieve::operator+=(const Sieve& other) {
  generated += other.generated;
  reachable += other.reachable;
  collisionFree += other.collisionFree;
  stable += other.stable;
  seeing += other.seeing;
  return *this;
}

RandomAttitude::RandomAttitude(const Robot& robot, const Scene& scene, const PoseOptions& options, std::size_t first)
    : robot_{robot}, scene_{scene}, checks_{robot, options}, legs_{robot, options}, head_{headJoints(robot)},
      hanging_{scene.drawn()}, point_(legs_.ranges() + head_.size()) {
  points_ = unitPoints(options.sampling, options.seed, point_.size(), options.tries, first);
  std::seed_seq mixed{options.seed, static_cast<std::uint64_t>(first), std::uint64_t{1}};
  random_.seed(mixed);
  takeToRest(robot, hanging_);
}

std::optional<SievedPose> RandomAttitude::draw(Sieve& sieve) {
  points_->next(point_);
  return attempt(30, sieve);
}

std::optional<SievedPose> RandomAttitude::at(const std::vector<double>& point, Sieve& sieve) {
  point_ = point;
  return attempt(1, sieve);
}

std::optional<Belief> RandomAttitude::reached(const std::vector<double>& point) {
  point_ = point;
  used_ = 0;
  Belief belief = hanging_;
  const auto draw = [&](const Interval& interval) { return from(interval); };
  if (!legs_.bend(belief, draw) || !checks_.withinLimits(belief, legs_.joints())) {
    return std::nullopt;
  }
  turnHead(belief, draw);
  return belief;
}

std::optional<SievedPose> RandomAttitude::attempt(int glances, Sieve& sieve) {
  ++sieve.generated;
  const auto belief = reached(point_);
  if (!belief) {
    return std::nullopt;
  }
  ++sieve.reachable;
  const Posture torsoFromLink = posture(robot_, *belief);
  if (checks_.touchesItself(torsoFromLink)) {
    return std::nullopt;
  }
  ++sieve.collisionFree;
  const auto share = checks_.standing(*belief, torsoFromLink, random_);
  if (!share) {
    return std::nullopt;
  }
  ++sieve.stable;
  SievedPose result{*belief, point_, *share};
  if (!lookAround(result, glances)) {
    return std::nullopt;
  }
  ++sieve.seeing;
  for (std::size_t i = 0; i < head_.size(); ++i) {
    const AngleRange& limits = robot_.joints[head_[i]].limits;
    result.point[legs_.ranges() + i] = (result.belief.angle(head_[i]) - limits.lower) / (limits.upper - limits.lower);
  }
  return result;
}

void RandomAttitude::turnHead(Belief& belief, const DrawnNumber& draw) const {
  for (const std::size_t joint : head_) {
    belief.angle(joint) = draw({robot_.joints[joint].limits.lower, robot_.joints[joint].limits.upper});
  }
}

bool RandomAttitude::lookAround(SievedPose& attitude, int glances) {
  Belief& belief = attitude.belief;
  for (int glance = 0; glance < glances; ++glance) {
    if (glance > 0) {
      turnHead(belief, [&](const Interval& interval) {
        return std::uniform_real_distribution{interval.lower, interval.upper}(random_);
      });
    }
    if (!checks_.withinLimits(belief, head_)) {
      continue;
    }
    const Posture torsoFromLink = posture(robot_, belief);
    if (scene_.sights(belief, torsoFromLink).empty()) {
      continue;
    }
    const auto share = checks_.touchesItself(torsoFromLink) ? std::nullopt
                       : glance == 0                        ? std::optional{attitude.standing}
                                                            : checks_.standing(belief, torsoFromLink, random_);
    attitude.standing = share.value_or(0);
    return share.has_value();
  }
  return false;
}

double RandomAttitude::from(const Interval& interval) {
  return interval.lower + point_[used_++] * (interval.upper - interval.lower);
}

} // namespace naocal
