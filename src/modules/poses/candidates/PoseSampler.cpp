#include "poses/candidates/PoseSampler.hpp"

#include "io/InputError.hpp"
#include "math/Checkpoints.hpp"
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

constexpr std::size_t chunk = 5000; // samples per chunk

/// J^T (R + J_t s^2 J_t^T)^-1 J from J^T R^-1 J, by Woodbury: an offset and the deflections of its joint have the same
/// columns.
Eigen::MatrixXd whitenColumns(const Eigen::MatrixXd& gram, Eigen::Index joints, const Noise& noise) {
  const double deflection = noise.encoder * noise.encoder + noise.pose * noise.pose;
  const Eigen::MatrixXd byJoints = gram.leftCols(joints);
  Eigen::MatrixXd inner = byJoints.topRows(joints);
  inner.diagonal().array() += 1 / deflection;
  const Eigen::MatrixXd half = inner.llt().matrixL().solve(byJoints.transpose());
  return gram - half.transpose() * half;
}

std::vector<std::size_t> headJoints(const Robot& robot) {
  std::set<std::size_t> joints;
  for (const CameraMount& camera : robot.cameras) {
    const std::vector<std::size_t> ofCamera = ancestorJoints(robot, camera.link);
    joints.insert(ofCamera.begin(), ofCamera.end());
  }
  return {joints.begin(), joints.end()};
}

} // namespace

PoseCandidates samplePoses(const Robot& robot, const PlanningScene& scene, const PoseOptions& options,
                           const std::function<void(std::size_t)>& progress) {
  const std::size_t chunks = (options.maxAttempts + chunk - 1) / chunk;
  std::vector<PoseCandidates> parts(chunks);
  std::mutex telling;
  std::size_t tried = 0;
  parallelFor(chunks, [&](std::size_t i) {
    PoseSampler attitudes{robot, scene, options, i * chunk};
    const std::size_t count = std::min(chunk, options.maxAttempts - i * chunk);
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

std::vector<Eigen::MatrixXd> computeInformation(const Robot& robot, const PlanningScene& scene,
                                                const std::vector<ValidPose>& poses, const Noise& noise) {
  std::vector<Eigen::MatrixXd> result(poses.size());
  parallelFor(poses.size(), [&](std::size_t i) {
    const auto joints = static_cast<Eigen::Index>(robot.joints.size());
    ModelState modelState = scene.nominalState(); // the boards may have moved since the pose was sampled
    modelState.values.head(joints) = poses[i].modelState.values.head(joints);
    result[i] =
        whitenColumns(scene.information(modelState, forwardKinematics(robot, modelState), noise.pixel), joints, noise);
  });
  return result;
}

std::vector<ModelState> sampleStableStates(const Robot& robot, const PlanningScene& scene, const PoseOptions& options,
                                           std::size_t count) {
  PoseSampler attitudes{robot, scene, options};
  std::vector<ModelState> found;
  PassCounts sieve;
  for (std::size_t tried = 0; tried < options.maxAttempts && found.size() < count; ++tried) {
    Checkpoints::reach();
    if (const auto attitude = attitudes.draw(sieve)) {
      found.push_back(attitude->modelState);
    }
  }
  return found;
}

std::vector<PlannedPose> planInformativePoses(const Robot& robot, const std::vector<Board>& boards,
                                              const std::map<std::string, CameraIntrinsics>& cameras,
                                              const PoseOptions& options) {
  const PlanningScene scene{robot, options.supportFoot, boards, cameras, options.sight};
  const std::vector<ModelState> found = sampleStableStates(robot, scene, options, options.choice * options.count);
  if (found.size() < options.count) {
    throw InputError{fmt::format("expected {} stable poses that see a board, found {} in {} attempts; put the boards "
                                 "nearer or ask for fewer poses",
                                 options.count, found.size(), options.maxAttempts)};
  }
  std::vector<Eigen::MatrixXd> informations;
  for (const ModelState& modelState : found) {
    informations.push_back(scene.information(modelState, forwardKinematics(robot, modelState)));
  }
  std::vector<PlannedPose> poses;
  for (const std::size_t chosen : selectDOptimal(scene.priorInformation(), informations, options.count)) {
    const ModelState& modelState = found[chosen];
    poses.push_back({options.supportFoot, modelState.values.head(static_cast<Eigen::Index>(robot.joints.size())),
                     scene.visibleBoards(modelState, forwardKinematics(robot, modelState))});
  }
  return poses;
}

PassCounts& PassCounts::operator+=(const PassCounts& other) {
  generated += other.generated;
  reachable += other.reachable;
  collisionFree += other.collisionFree;
  stable += other.stable;
  seeing += other.seeing;
  return *this;
}

PoseSampler::PoseSampler(const Robot& robot, const PlanningScene& scene, const PoseOptions& options, std::size_t first)
    : robot_{robot}, scene_{scene}, checks_{robot, options}, legs_{robot, options}, head_{headJoints(robot)},
      hanging_{scene.nominalState()}, point_(legs_.dimension() + head_.size()) {
  points_ = makeSampler(options.sampling, options.seed, point_.size(), options.maxAttempts, first);
  std::seed_seq mixed{options.seed, static_cast<std::uint64_t>(first), std::uint64_t{1}};
  random_.seed(mixed);
  moveToRest(robot, hanging_);
}

std::optional<ValidPose> PoseSampler::draw(PassCounts& sieve) {
  points_->next(point_);
  return attempt(30, sieve);
}

std::optional<ValidPose> PoseSampler::sampleAt(const std::vector<double>& point, PassCounts& sieve) {
  point_ = point;
  return attempt(1, sieve);
}

std::optional<ModelState> PoseSampler::stateAt(const std::vector<double>& point) {
  point_ = point;
  used_ = 0;
  ModelState modelState = hanging_;
  const auto draw = [&](const Interval& interval) { return from(interval); };
  if (!legs_.reachStance(modelState, draw) || !checks_.isWithinLimits(modelState, legs_.joints())) {
    return std::nullopt;
  }
  turnHead(modelState, draw);
  return modelState;
}

std::optional<ValidPose> PoseSampler::attempt(int glances, PassCounts& sieve) {
  ++sieve.generated;
  const auto modelState = stateAt(point_);
  if (!modelState) {
    return std::nullopt;
  }
  ++sieve.reachable;
  const LinkPoses torsoFromLink = forwardKinematics(robot_, *modelState);
  if (checks_.selfCollides(torsoFromLink)) {
    return std::nullopt;
  }
  ++sieve.collisionFree;
  const auto share = checks_.balancedFraction(*modelState, torsoFromLink, random_);
  if (!share) {
    return std::nullopt;
  }
  ++sieve.stable;
  ValidPose result{*modelState, point_, *share};
  if (!lookAround(result, glances)) {
    return std::nullopt;
  }
  ++sieve.seeing;
  for (std::size_t i = 0; i < head_.size(); ++i) {
    const AngleRange& limits = robot_.joints[head_[i]].limits;
    result.point[legs_.dimension() + i] =
        (result.modelState.angle(head_[i]) - limits.lower) / (limits.upper - limits.lower);
  }
  return result;
}

void PoseSampler::turnHead(ModelState& modelState, const NumberSource& draw) const {
  for (const std::size_t joint : head_) {
    modelState.angle(joint) = draw({robot_.joints[joint].limits.lower, robot_.joints[joint].limits.upper});
  }
}

bool PoseSampler::lookAround(ValidPose& attitude, int glances) {
  ModelState& modelState = attitude.modelState;
  for (int glance = 0; glance < glances; ++glance) {
    if (glance > 0) {
      turnHead(modelState, [&](const Interval& interval) {
        return std::uniform_real_distribution{interval.lower, interval.upper}(random_);
      });
    }
    if (!checks_.isWithinLimits(modelState, head_)) {
      continue;
    }
    const LinkPoses torsoFromLink = forwardKinematics(robot_, modelState);
    if (scene_.visibleBoards(modelState, torsoFromLink).empty()) {
      continue;
    }
    const auto share = checks_.selfCollides(torsoFromLink) ? std::nullopt
                       : glance == 0                       ? std::optional{attitude.standing}
                                     : checks_.balancedFraction(modelState, torsoFromLink, random_);
    attitude.standing = share.value_or(0);
    return share.has_value();
  }
  return false;
}

double PoseSampler::from(const Interval& interval) {
  return interval.lower + point_[used_++] * (interval.upper - interval.lower);
}

std::vector<Eigen::VectorXd> drawPerturbedRobots(const Robot& robot, const PoseOptions& options, std::size_t count,
                                                 std::uint64_t number) {
  std::seed_seq mixed{options.seed, number};
  std::mt19937_64 random{mixed};
  std::uniform_real_distribution<double> error{-options.stability.jointError, options.stability.jointError};
  std::vector<Eigen::VectorXd> result(count, Eigen::VectorXd(eigenIndex(robot.joints.size())));
  for (Eigen::VectorXd& errors : result) {
    std::generate(errors.begin(), errors.end(), [&] { return error(random); });
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      errors[eigenIndex(joint)] = errors[eigenIndex(robot.joints[joint].motor)];
    }
  }
  return result;
}

std::vector<ValidPose> applyErrors(const Eigen::VectorXd& errors, std::vector<ValidPose> poses) {
  for (ValidPose& pose : poses) {
    pose.modelState.values.head(errors.size()) += errors;
  }
  return poses;
}

} // namespace naocal
