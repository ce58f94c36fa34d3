#include "poses/PlanOptimizer.hpp"

#include "io/InputError.hpp"
#include "math/Parallel.hpp"
#include "poses/candidates/BoardPlacement.hpp"
#include "poses/candidates/PoseSampler.hpp"
#include "poses/candidates/Transitions.hpp"
#include "poses/criteria/EffectPairCriterion.hpp"
#include "poses/criteria/PlanOptions.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace naocal {

void PlanRefiner::refinePoses(PlanDraft& draft) {
  const PlanEvaluator score{robot_, draft.boards, cameras_, options_};
  PoseSampler attitudes{robot_, score.scene(), options_.poses};
  std::vector<Eigen::MatrixXd> own = score.informationParts(draft.poses);
  Eigen::MatrixXd sum = score.totalInformation(draft.poses);
  double now = score.objective(sum, draft.poses);
  PassCounts unused;
  const std::size_t attempts = options_.refinements * draft.poses.size();
  for (std::size_t attempt = 0; attempt < attempts; ++attempt) {
    const std::size_t i = attempt % draft.poses.size();
    std::vector<double> point = draft.poses[i].point;
    for (double& number : point) {
      number = std::clamp(number + step(attempt, attempts), 0.0, 1.0);
    }
    auto moved = attitudes.sampleAt(point, unused);
    if (!moved) {
      continue;
    }
    const Eigen::MatrixXd part = score.informationParts({*moved}).front();
    const Eigen::MatrixXd with = sum - own[i] + part;
    std::swap(draft.poses[i], *moved);
    if (const double there = score.objective(with, draft.poses); there < now) {
      now = there;
      sum = with;
      own[i] = part;
    } else {
      std::swap(draft.poses[i], *moved);
    }
  }
}

void PlanRefiner::refineBoards(PlanDraft& draft) {
  const BoardPlacementRules places{robot_, options_.poses.supportFoot, options_.farthestBoard, options_.gap};
  const MirroredBoards mirror{draft.boards, midlineBetweenFeet(options_.poses.supportFoot)};
  double now = value(draft);
  const std::size_t attempts = options_.refinements * draft.boards.size();
  for (std::size_t attempt = 0; attempt < attempts; ++attempt) {
    const std::size_t i = attempt % draft.boards.size();
    const std::vector<Board> before = draft.boards;
    Placement& place = *draft.boards[i].placement;
    const double size = 0.3 * step(attempt, attempts); // [m], 1 sigma of a move
    std::normal_distribution<double> move;
    place.x += size * move(random_);
    place.y += size * move(random_);
    place.yaw += 5 * size * move(random_);
    if (options_.mirrored) {
      mirror.mirrorMoved(draft.boards, i);
    }
    const bool allowed = places.isAllowed(draft.boards, i) &&
                         (!options_.mirrored || places.isAllowed(draft.boards, mirror.mirrorImageOf(i)));
    if (const double there = allowed ? value(draft) : now; there < now) {
      now = there;
    } else {
      draft.boards = before;
    }
  }
}

double PlanRefiner::value(const PlanDraft& draft) const {
  const PlanEvaluator score{robot_, draft.boards, cameras_, options_};
  Eigen::MatrixXd sum = score.priorInformation();
  for (const Eigen::MatrixXd& part : score.informationParts(draft.poses)) {
    if (part.leftCols(part.rows()).isZero()) {
      return std::numeric_limits<double>::infinity(); // a pose sees no board
    }
    sum += part;
  }
  return score.objective(sum, draft.poses);
}

double PlanRefiner::step(std::size_t attempt, std::size_t attempts) {
  const double width = 0.15 * std::pow(0.05, static_cast<double>(attempt) / static_cast<double>(attempts));
  return std::normal_distribution<double>{0, width}(random_);
}

PlanEvaluator::PlanEvaluator(const Robot& robot, const std::vector<Board>& boards,
                             const std::map<std::string, CameraIntrinsics>& cameras, const PlanOptions& options)
    : robot_{robot}, cameras_{cameras}, options_{options}, boards_{boards}, scene_{robot, options.poses.supportFoot,
                                                                                   boards, cameras,
                                                                                   options.poses.sight},
      joints_{scene_.joints()}, judge_{robot, scene_, joints_, options.criterion, options.known},
      perturbedErrors_{drawPerturbedRobots(robot, options.poses, options.perturbedRobots, 1)},
      known_{judge_.prior().replicate(1, static_cast<Eigen::Index>(perturbedErrors_.size() + 1))} {
  for (const Eigen::VectorXd& angles : options.kept) {
    kept_.push_back({scene_.nominalState(), {}, 0});
    kept_.back().modelState.values.head(angles.size()) = angles;
  }
  for (const Eigen::MatrixXd& part : informationParts(kept_)) {
    known_ += part;
  }
}

ThesisCriterion PlanEvaluator::thesis() const {
  return {robot_, supportSole(robot_, options_.poses.supportFoot), cameras_, joints_, options_.weights};
}

Interaction PlanEvaluator::interaction(const std::vector<ValidPose>& poses) const {
  return thesis().interaction(poses);
}

std::vector<ValidPose> PlanEvaluator::selectPoses(const std::vector<ValidPose>& candidates, std::size_t count) const {
  if (options_.criterion == Criterion::discriminate) {
    return EffectPairCriterion{robot_, boards_, cameras_, options_}.selectPoses(kept_, candidates, count);
  }
  const std::vector<std::size_t> indices =
      options_.criterion == Criterion::interaction
          ? thesis().selectChain(candidates, count)
          : naocal::selectPoses(judge_, expectedInformation(known_), expectedParts(candidates), count);
  std::vector<ValidPose> result;
  for (const std::size_t index : indices) {
    result.push_back(candidates[index]);
  }
  return result;
}

std::optional<double> PlanEvaluator::misfit(const std::vector<ValidPose>& poses) const {
  return options_.effects.empty()
             ? std::nullopt
             : std::optional{EffectPairCriterion{robot_, boards_, cameras_, options_}.misfit(kept_, poses)};
}

std::vector<Eigen::MatrixXd> PlanEvaluator::partsOfDrawn(const std::vector<ValidPose>& poses) const {
  std::vector<Eigen::MatrixXd> result = computeInformation(robot_, scene_, poses, options_.noise);
  for (Eigen::MatrixXd& information : result) {
    information = judge_.relevantInformation(information);
  }
  return result;
}

Eigen::MatrixXd PlanEvaluator::expectedInformation(const Eigen::MatrixXd& sum) const {
  Eigen::MatrixXd result = ofRobot(sum, 0);
  for (std::size_t robot = 1; robot <= perturbedErrors_.size(); ++robot) {
    result += ofRobot(sum, robot) / static_cast<double>(perturbedErrors_.size());
  }
  return result;
}

std::vector<Eigen::MatrixXd> PlanEvaluator::expectedParts(const std::vector<ValidPose>& poses) const {
  std::vector<Eigen::MatrixXd> result = partsOfDrawn(poses);
  for (const Eigen::VectorXd& errors : perturbedErrors_) {
    const std::vector<Eigen::MatrixXd> own = partsOfDrawn(applyErrors(errors, poses));
    for (std::size_t pose = 0; pose < poses.size(); ++pose) {
      result[pose] += own[pose] / static_cast<double>(perturbedErrors_.size());
    }
  }
  return result;
}

std::vector<Eigen::MatrixXd> PlanEvaluator::informationParts(const std::vector<ValidPose>& poses) const {
  std::vector<Eigen::MatrixXd> result = partsOfDrawn(poses);
  for (std::size_t robot = 0; robot < perturbedErrors_.size(); ++robot) {
    const std::vector<Eigen::MatrixXd> own = partsOfDrawn(applyErrors(perturbedErrors_[robot], poses));
    for (std::size_t pose = 0; pose < poses.size(); ++pose) {
      if (robot == 0) {
        result[pose].conservativeResize(Eigen::NoChange, known_.cols());
      }
      result[pose].middleCols(static_cast<Eigen::Index>(robot + 1) * known_.rows(), known_.rows()) = own[pose];
    }
  }
  return result;
}

Eigen::MatrixXd PlanEvaluator::ofRobot(const Eigen::MatrixXd& sum, std::size_t robot) const {
  return sum.middleCols(static_cast<Eigen::Index>(robot) * sum.rows(), sum.rows());
}

Eigen::MatrixXd PlanEvaluator::totalInformation(const std::vector<ValidPose>& poses) const {
  Eigen::MatrixXd result = known_;
  for (const Eigen::MatrixXd& part : informationParts(poses)) {
    result += part;
  }
  return result;
}

double PlanEvaluator::worstSigma(const Eigen::MatrixXd& sum) const {
  const Eigen::VectorXd variances = judge_.covariance(ofRobot(sum, 0)).diagonal();
  return variances.size() == 0 ? 0 : std::sqrt(variances.maxCoeff());
}

double PlanEvaluator::objective(const Eigen::MatrixXd& sum, const std::vector<ValidPose>& poses) const {
  if (options_.criterion != Criterion::time) {
    double ofWorn = 0;
    for (std::size_t robot = 1; robot <= perturbedErrors_.size(); ++robot) {
      ofWorn += judge_(ofRobot(sum, robot)) / static_cast<double>(perturbedErrors_.size());
    }
    return judge_(ofRobot(sum, 0)) + ofWorn;
  }
  constexpr double farMore = 1e6;
  const double missing = worstSigma(sum) / options_.sigma;
  return missing > 1 ? farMore * missing : playTime(robot_, poses, options_.secondsPerPose);
}

std::map<std::string, double> PlanEvaluator::sigmas(const std::vector<ValidPose>& poses, bool known) const {
  const PoseCriterion judge{robot_, scene_, joints_, options_.criterion, known};
  Eigen::MatrixXd sum = judge.prior();
  for (const std::vector<ValidPose>* each : {&kept_, &poses}) {
    for (const Eigen::MatrixXd& information : computeInformation(robot_, scene_, *each, options_.noise)) {
      sum += judge.relevantInformation(information);
    }
  }
  return nameSigmas(judge.covariance(sum).diagonal());
}

std::map<std::string, double> PlanEvaluator::perturbedSigmas(const std::vector<ValidPose>& poses) const {
  constexpr std::size_t robots = 100;
  std::vector<ValidPose> all = kept_;
  all.insert(all.end(), poses.begin(), poses.end());
  Eigen::VectorXd variances = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(joints_.size()));
  for (const Eigen::VectorXd& errors : drawPerturbedRobots(robot_, options_.poses, robots, 2)) {
    Eigen::MatrixXd sum = judge_.prior();
    for (const Eigen::MatrixXd& part : partsOfDrawn(applyErrors(errors, all))) {
      sum += part;
    }
    variances += judge_.covariance(sum).diagonal() / robots;
  }
  return nameSigmas(variances);
}

std::map<std::string, double> PlanEvaluator::nameSigmas(const Eigen::VectorXd& variances) const {
  std::map<std::string, double> result;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    result[robot_.joints[joints_[i]].name] = std::sqrt(variances[static_cast<Eigen::Index>(i)]);
  }
  return result;
}

namespace {

PlanOptions ofDrawnRobot(PlanOptions options) {
  options.perturbedRobots = 0;
  return options;
}

} // namespace

PlanDraft PlanOptimizer::optimize(const std::vector<Board>& boards, const std::vector<ValidPose>& attitudes) {
  if (options_.criterion == Criterion::time) {
    return quickest(boards, attitudes);
  }
  if (options_.criterion == Criterion::interaction || options_.criterion == Criterion::discriminate) {
    return {PlanEvaluator{robot_, boards, cameras_, options_}.selectPoses(attitudes, options_.poses.count), boards};
  }
  return refineFromStarts(boards, attitudes);
}

/// Selects for perturbed robots too, but refines for the drawn robot first: refining for perturbed robots takes many
/// times as long.
PlanDraft PlanOptimizer::refineFromStarts(const std::vector<Board>& boards, const std::vector<ValidPose>& attitudes) {
  const PlanOptions drawn = ofDrawnRobot(options_);
  std::vector<PlanDraft> drafts(options_.starts, PlanDraft{{}, boards});
  parallelFor(drafts.size(), [&](std::size_t i) {
    PlanOptions beginning = options_;
    beginning.criterion = static_cast<Criterion>(i % static_cast<std::size_t>(Criterion::interaction));
    drafts[i].poses = PlanEvaluator{robot_, boards, cameras_, beginning}.selectPoses(attitudes, options_.poses.count);
    refine(drafts[i], attitudes, drawn, i);
  });
  PlanDraft best = *std::min_element(drafts.begin(), drafts.end(), [&](const PlanDraft& one, const PlanDraft& other) {
    return value(one, options_) < value(other, options_);
  });
  for (std::size_t round = 1; round < options_.rounds; ++round) {
    refine(best, attitudes, options_, options_.starts + round);
  }
  return best;
}

PlanDraft PlanOptimizer::quickest(const std::vector<Board>& boards, const std::vector<ValidPose>& attitudes) {
  constexpr double reached = 1e5; // [s]
  PlanOptions options = ofDrawnRobot(options_);
  PlanDraft best;
  double least = std::numeric_limits<double>::infinity();
  for (options.poses.count = 2; options.poses.count <= options_.poses.count; ++options.poses.count) {
    PlanDraft draft{PlanEvaluator{robot_, boards, cameras_, options}.selectPoses(attitudes, options.poses.count),
                    boards};
    refine(draft, attitudes, options, options.poses.count);
    const double there = value(draft, options);
    if (there > least && least < reached) {
      break;
    }
    if (there < least) {
      least = there;
      best = std::move(draft);
    }
  }
  if (least > reached) {
    throw InputError{
        fmt::format("expected at most {} poses to tell every offset to {:.3f} degrees, found {:.3f}; ask for more "
                    "poses or less",
                    options_.poses.count, degrees(options_.sigma), worstSigma(best))};
  }
  return best;
}

/// Refines a draft; then selects again with the refined poses as additional candidates, and refines once more.
void PlanOptimizer::refine(PlanDraft& draft, std::vector<ValidPose> attitudes, const PlanOptions& options,
                           std::uint64_t seed) {
  PlanRefiner refinement{robot_, cameras_, options, options.poses.seed + seed};
  for (const bool again : {false, true}) {
    if (again && options.criterion != Criterion::time) {
      attitudes.insert(attitudes.end(), draft.poses.begin(), draft.poses.end());
      draft.poses = PlanEvaluator{robot_, draft.boards, cameras_, options}.selectPoses(attitudes, options.poses.count);
    }
    refinement.refinePoses(draft);
    if (options.moveBoards) {
      refinement.refineBoards(draft);
    }
  }
  const std::string found =
      fmt::format("refined {} poses: the worst offset's sigma is {:.4f} deg", draft.poses.size(), worstSigma(draft));
  const std::lock_guard lock{telling_};
  tell_(found);
}

double PlanOptimizer::value(const PlanDraft& draft, const PlanOptions& options) const {
  const PlanEvaluator here{robot_, draft.boards, cameras_, options};
  return here.objective(here.totalInformation(draft.poses), draft.poses);
}

double PlanOptimizer::worstSigma(const PlanDraft& draft) const { // [deg]
  const PlanEvaluator here{robot_, draft.boards, cameras_, options_};
  return degrees(here.worstSigma(here.totalInformation(draft.poses)));
}

} // namespace naocal
