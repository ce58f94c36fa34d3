#include "poses/PosePlan.hpp"

#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/Parallel.hpp"
#include "poses/PlanOptimizer.hpp"
#include "poses/candidates/BoardPlacement.hpp"
#include "poses/candidates/PoseValidity.hpp"
#include "poses/criteria/PlanOptions.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace naocal {

namespace {

/// The largest multiple of most / 20 for which `well` holds; assumes that `well` is monotonic.
template <typename Well> double largest(double most, const Well& well) {
  constexpr int steps = 20;
  int step = 0;
  while (step < steps && well(most * (step + 1) / steps)) {
    ++step;
  }
  return most * step / steps;
}

double largest(const std::map<std::string, double>& sigmas) {
  double result = 0;
  for (const auto& [joint, sigma] : sigmas) {
    result = std::max(result, sigma);
  }
  return result;
}

double rootMeanSquare(const std::map<std::string, double>& sigmas) {
  double sum = 0;
  for (const auto& [joint, sigma] : sigmas) {
    sum += sigma * sigma;
  }
  return std::sqrt(sum / static_cast<double>(sigmas.size()));
}

/// Merges sigmas, keeping the smaller one per joint.
void take(std::map<std::string, double>& sigmas, const std::map<std::string, double>& more) {
  for (const auto& [joint, sigma] : more) {
    const auto known = sigmas.try_emplace(joint, sigma).first;
    known->second = std::min(known->second, sigma);
  }
}

/// Adds the mirror image of every pose, on the other foot among the same, symmetric boards (PlanOptions::mirrored); the
/// feet are side by side when the support changes. Sigmas: computed per foot, the smaller one for the head. Throws
/// InputError if a mirror image is not a valid pose.
void addMirroredPoses(PosePlan& plan, const Robot& robot, const std::map<std::string, CameraIntrinsics>& cameras) {
  PlanOptions options = plan.options;
  const bool left = options.poses.supportFoot == SupportFoot::left;
  options.poses.supportFoot = left ? SupportFoot::right : SupportFoot::left;
  std::vector<Board> boards = plan.boards; // relative to the other sole
  for (Board& board : boards) {
    board.placement->y += left ? footDistance : -footDistance;
  }
  const PlanEvaluator score{robot, boards, cameras, options};
  const PoseValidity checks{robot, options.poses};
  std::vector<ValidPose> images;
  const std::size_t count = plan.poses.size();
  for (std::size_t i = 0; i < count; ++i) {
    ValidPose image{score.scene().nominalState(), {}, plan.standing[i]};
    image.modelState.values.head(eigenIndex(robot.joints.size())) = mirrorAngles(robot, plan.poses[i].pose.angles);
    const LinkPoses torsoFromLink = forwardKinematics(robot, image.modelState);
    if (checks.selfCollides(torsoFromLink) ||
        !isBalanced(robot, torsoFromLink, options.poses.supportFoot, {0.01, 0.01})) {
      throw InputError{fmt::format("pose {}: its mirror image is not valid; plan the other foot by itself", i)};
    }
    plan.poses.push_back({{options.poses.supportFoot, image.modelState.values.head(eigenIndex(robot.joints.size())),
                           score.scene().visibleBoards(image.modelState, torsoFromLink)},
                          Eigen::VectorXd::Zero(eigenIndex(robot.joints.size()))});
    plan.standing.push_back(plan.standing[i]);
    plan.ways.push_back(plan.ways[i]);
    if (plan.ways.back()) {
      for (Eigen::VectorXd& angles : plan.ways.back()->via) {
        angles = mirrorAngles(robot, angles);
      }
    }
    images.push_back(std::move(image));
  }
  take(plan.sigma, score.sigmas(images, false));
  take(plan.sigmaKnown, score.sigmas(images, true));
  take(plan.sigmaOfRobots, score.perturbedSigmas(images));
}

/// Computes the tolerance of each board.
std::vector<BoardTolerance> computeBoardTolerances(const Robot& robot, const PlanInputs& inputs,
                                                   const PlanOptions& options, const std::vector<ValidPose>& poses) {
  constexpr double growth = 1.1, farthest = 0.3, mostTurned = std::numbers::pi / 4; // [1], [m], [rad]
  PlanOptions drawn = options;
  drawn.perturbedRobots = 0;
  const auto worst = [&](const std::vector<Board>& laid) { // absent: a pose sees no board
    const PlanEvaluator score{robot, laid, inputs.cameras, drawn};
    const std::vector<Eigen::MatrixXd> parts = score.informationParts(poses);
    const bool blind = std::any_of(parts.begin(), parts.end(), [](const auto& part) { return part.isZero(); });
    return blind ? std::nullopt : std::optional{score.worstSigma(score.totalInformation(poses))};
  };
  const double allowed = growth * worst(inputs.boards).value_or(0);
  std::vector<BoardTolerance> result(inputs.boards.size());
  parallelFor(inputs.boards.size(), [&](std::size_t i) {
    const auto well = [&](double x, double y, double yaw) {
      std::vector<Board> laid = inputs.boards;
      laid[i].placement->x += x;
      laid[i].placement->y += y;
      laid[i].placement->yaw += yaw;
      const auto sigma = worst(laid);
      return sigma && *sigma <= allowed;
    };
    result[i].shift = farthest;
    for (int direction = 0; direction < 8; ++direction) {
      const double angle = direction * std::numbers::pi / 4;
      result[i].shift = largest(result[i].shift,
                                [&](double size) { return well(size * std::cos(angle), size * std::sin(angle), 0); });
    }
    result[i].turn = largest(mostTurned, [&](double size) { return well(0, 0, size) && well(0, 0, -size); });
  });
  return result;
}

/// Runs the planning steps on one draft.
class Planner {
public:
  Planner(const Robot& robot, PlanInputs inputs, const PlanOptions& options,
          const std::function<void(const std::string&)>& tell)
      : robot_{robot}, cameras_{std::move(inputs.cameras)}, options_{options}, tell_{tell}, draft_{{},
                                                                                                   std::move(
                                                                                                       inputs.boards)} {
    if (options_.mirrored) {
      const MirroredBoards mirror{draft_.boards, midlineBetweenFeet(options_.poses.supportFoot)};
      for (std::size_t board = 0; board < draft_.boards.size(); ++board) {
        mirror.mirrorMoved(draft_.boards, board);
      }
    }
  }

  PosePlan plan() {
    PosePlan result;
    tell_(fmt::format("filtering {} candidate poses", options_.poses.maxAttempts));
    PoseCandidates candidates = samplePoses(robot_, score().scene(), options_.poses);
    if (candidates.attitudes.size() < options_.poses.count) {
      throw InputError{fmt::format("expected {} stable poses that see a board, found {} among {} candidates; put the "
                                   "boards nearer, try more candidates or ask for fewer poses",
                                   options_.poses.count, candidates.attitudes.size(), options_.poses.maxAttempts)};
    }
    thin(candidates.attitudes);
    if (options_.compare) {
      tell_("comparing what the criteria select");
      result.comparison = compareCriteria(robot_, {draft_.boards, cameras_}, options_, candidates.attitudes);
    }
    draft_ = PlanOptimizer{robot_, cameras_, options_, tell_}.optimize(draft_.boards, candidates.attitudes);
    options_.poses.count = draft_.poses.size();
    describe(result);
    result.sieve = candidates.sieve;
    return result;
  }

private:
  PlanEvaluator score() const { return {robot_, draft_.boards, cameras_, options_}; }

  /// Limits the candidates, evenly: on both feet a million samples give about 100 000 of them, without benefit.
  void thin(std::vector<ValidPose>& attitudes) const {
    if (attitudes.size() > options_.maxCandidates) {
      for (std::size_t i = 0; i < options_.maxCandidates; ++i) {
        std::swap(attitudes[i], attitudes[i * attitudes.size() / options_.maxCandidates]);
      }
      attitudes.resize(options_.maxCandidates, attitudes.front());
    }
  }

  void describe(PosePlan& result) {
    const PlanEvaluator here = score();
    OrderedPoses ordered = orderPoses(robot_, here.scene(), options_.poses, std::move(draft_.poses));
    draft_.poses = std::move(ordered.poses);
    result.ways = std::move(ordered.ways);
    result.supportFoot = options_.poses.supportFoot;
    result.boards = draft_.boards;
    result.sigma = here.sigmas(draft_.poses, false);
    result.sigmaKnown = here.sigmas(draft_.poses, true);
    result.sigmaOfRobots = here.perturbedSigmas(draft_.poses);
    result.interaction = here.interaction(draft_.poses);
    result.misfit = here.misfit(draft_.poses);
    result.tolerances = computeBoardTolerances(robot_, {draft_.boards, cameras_}, options_, draft_.poses);
    result.kept = options_.kept.size();
    std::vector<ValidPose> all = here.keptPoses();
    all.insert(all.end(), draft_.poses.begin(), draft_.poses.end());
    result.ways.insert(result.ways.begin(), result.kept, std::nullopt);
    const auto joints = static_cast<Eigen::Index>(robot_.joints.size());
    for (const ValidPose& attitude : all) {
      ModelState modelState = here.scene().nominalState();
      modelState.values.head(joints) = attitude.modelState.values.head(joints);
      result.poses.push_back({{options_.poses.supportFoot, modelState.values.head(joints),
                               here.scene().visibleBoards(modelState, forwardKinematics(robot_, modelState))},
                              attitude.approach.size() > 0 ? attitude.approach : Eigen::VectorXd::Zero(joints)});
      result.standing.push_back(attitude.standing);
    }
    result.options = options_;
    if (options_.mirrored) {
      addMirroredPoses(result, robot_, cameras_);
    }
  }

  const Robot& robot_;
  std::map<std::string, CameraIntrinsics> cameras_;
  PlanOptions options_;
  const std::function<void(const std::string&)>& tell_;
  PlanDraft draft_;
};

} // namespace

std::vector<CriterionResult> compareCriteria(const Robot& robot, const PlanInputs& inputs, const PlanOptions& options,
                                             const std::vector<ValidPose>& candidates) {
  std::vector<CriterionResult> result;
  for (std::size_t criterion = 0; criterion < static_cast<std::size_t>(Criterion::time); ++criterion) {
    if (static_cast<Criterion>(criterion) == Criterion::discriminate && options.effects.empty()) {
      continue;
    }
    PlanOptions own = options;
    own.perturbedRobots = 0;
    own.criterion = static_cast<Criterion>(criterion);
    const PlanEvaluator score{robot, inputs.boards, inputs.cameras, own};
    for (const std::size_t count : {3, 5, 8}) {
      const std::vector<ValidPose> poses = score.selectPoses(candidates, count);
      const std::map<std::string, double> unknown = score.sigmas(poses, false);
      result.push_back({own.criterion, poses.size(), largest(unknown), rootMeanSquare(unknown),
                        largest(score.sigmas(poses, true)), score.interaction(poses), score.misfit(poses)});
    }
  }
  return result;
}

PosePlan planPoses(const Robot& robot, PlanInputs inputs, const PlanOptions& options,
                   const std::function<void(const std::string&)>& tell) {
  const std::function<void(const std::string&)> quietly = [](const std::string&) {};
  return Planner{robot, std::move(inputs), options, tell ? tell : quietly}.plan();
}

} // namespace naocal
