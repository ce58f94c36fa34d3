#include "poses/candidates/PoseSampler.hpp"

#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/Parallel.hpp"
#include "math/SubsetSelection.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <fmt/format.h>
#include <mutex>
#include <random>
#include <set>

namespace naocal {

namespace {

constexpr std::size_t chunk = 5000; // attitudes

/// J^T (R + J_t s^2 J_t^T)^-1 J of J^T R^-1 J, by Woodbury: an offset and the deflections of its joint have the same
/// columns.
Eigen::MatrixXd whitened(const Eigen::MatrixXd& gram, Eigen::Index joints, const Noise& noise) {
  const double deflection = noise.encoder * noise.encoder + noise.pose * noise.pose;
  const Eigen::MatrixXd byJoints = gram.leftCols(joints);
  Eigen::MatrixXd inner = byJoints.topRows(joints);
  inner.diagonal().array() += 1 / deflection;
  const Eigen::MatrixXd half = inner.llt().matrixL().solve(byJoints.transpose());
  return gram - half.transpose() * half;
}

} // namespace

PoseCandidates poseCandidates(const Robot& robot, const Scene& scene, const PoseOptions& options,
                              const std::function<void(std::size_t)>& progress) {
  const std::size_t chunks = (options.tries + chunk - 1) / chunk;
  std::vector<PoseCandidates> parts(chunks);
  std::mutex telling;
  std::size_t tried = 0;
  inParallel(chunks, [&](std::size_t i) {
    RandomAttitude attitudes{robot, scene, options, i * chunk};
    const std::size_t count = std::min(chunk, options.tries - i * chunk);
    for (std::size_t k = 0; k < count; ++k) {
      if (auto attitude = attitudes.draw(parts[i].sieve)) {
        parts[i].attitudes.push_back(*std::move(attitude));
      }
    }
    const std::lock_guard lock{telling};
    tried += count;
    if (progress) {
      progress(tried);
    }
  });
  PoseCandidates all;
  for (PoseCandidates& part : parts) {
    all.sieve += part.sieve;
    std::move(part.attitudes.begin(), part.attitudes.end(), std::back_inserter(all.attitudes));
  }
  return all;
}

std::vector<Eigen::MatrixXd> informations(const Robot& robot, const Scene& scene, const std::vector<SievedPose>& poses,
                                          const Noise& noise) {
  std::vector<Eigen::MatrixXd> result(poses.size());
  inParallel(poses.size(), [&](std::size_t i) {
    const auto joints = static_cast<Eigen::Index>(robot.joints.size());
    Belief belief = scene.drawn(); // the boards may lie elsewhere than when the pose was drawn
    belief.values.head(joints) = poses[i].belief.values.head(joints);
    result[i] = whitened(scene.information(belief, posture(robot, belief), noise.pixel), joints, noise);
  });
  return result;
}

std::vector<Belief> stableAttitudes(const Robot& robot, const Scene& scene, const PoseOptions& options,
                                    std::size_t count) {
  RandomAttitude attitudes{robot, scene, options};
  std::vector<Belief> found;
  Sieve sieve;
  for (std::size_t tried = 0; tried < options.tries && found.size() < count; ++tried) {
    if (const auto attitude = attitudes.draw(sieve)) {
      found.push_back(attitude->belief);
    }
  }
  return found;
}

std::vector<PlannedPose> stablePoses(const Robot& robot, const std::vector<Board>& boards,
                                     const std::map<std::string, CameraIntrinsics>& cameras,
                                     const PoseOptions& options) {
  const Scene scene{robot, options.supportFoot, boards, cameras, options.sight};
  const std::vector<Belief> found = stableAttitudes(robot, scene, options, options.choice * options.count);
  if (found.size() < options.count) {
    throw InputError{fmt::format("expected {} stable poses that see a board, found {} in {} attempts; put the boards "
                                 "nearer or ask for fewer poses",
                                 options.count, found.size(), options.tries)};
  }
  std::vector<Eigen::MatrixXd> informations;
  for (const Belief& belief : found) {
    informations.push_back(scene.information(belief, posture(robot, belief)));
  }
  std::vector<PlannedPose> poses;
  for (const std::size_t chosen : mostInformative(scene.priorInformation(), informations, options.count)) {
    const Belief& belief = found[chosen];
    poses.push_back({options.supportFoot, belief.values.head(static_cast<Eigen::Index>(robot.joints.size())),
                     scene.sights(belief, posture(robot, belief))});
  }
  return poses;
}

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

std::vector<Eigen::VectorXd> wornRobots(const Robot& robot, const PoseOptions& options, std::size_t count,
                                        std::uint64_t number) {
  std::seed_seq mixed{options.seed, number};
  std::mt19937_64 random{mixed};
  std::uniform_real_distribution<double> error{-options.stability.jointError, options.stability.jointError};
  std::vector<Eigen::VectorXd> result(count, Eigen::VectorXd(at(robot.joints.size())));
  for (Eigen::VectorXd& errors : result) {
    std::generate(errors.begin(), errors.end(), [&] { return error(random); });
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      errors[at(joint)] = errors[at(robot.joints[joint].motor)];
    }
  }
  return result;
}

std::vector<SievedPose> takenBy(const Eigen::VectorXd& errors, std::vector<SievedPose> poses) {
  for (SievedPose& pose : poses) {
    pose.belief.values.head(errors.size()) += errors;
  }
  return poses;
}

} // namespace naocal
