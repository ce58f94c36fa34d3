#pragma once

#include "poses/candidates/PoseSampler.hpp"
#include "poses/criteria/PlanOptions.hpp"
#include "poses/criteria/PoseCriterion.hpp"
#include "poses/criteria/ThesisCriterion.hpp"

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Evaluates sets of poses by their information about the joint offsets, for fixed boards.
class PlanEvaluator {
public:
  PlanEvaluator(const Robot& robot, const std::vector<Board>& boards,
                const std::map<std::string, CameraIntrinsics>& cameras, const PlanOptions& options);

  const PlanningScene& scene() const { return scene_; }
  const PoseCriterion& criterion() const { return judge_; }
  /// Poses taken in addition (PlanOptions::kept).
  const std::vector<ValidPose>& keptPoses() const { return kept_; }

  /// The best set of `count` poses found for the criterion; the thesis's criterion may select fewer.
  std::vector<ValidPose> selectPoses(const std::vector<ValidPose>& candidates, std::size_t count) const;
  Interaction interaction(const std::vector<ValidPose>& poses) const;

  /// Misfit (chi2) of the wrong one of PlanOptions::effects after these poses (EffectPairCriterion); absent without
  /// effects.
  std::optional<double> misfit(const std::vector<ValidPose>& poses) const;

  /// Each pose's relevant information: blocks side by side, first for the drawn robot, then for each of
  /// PlanOptions::perturbedRobots.
  std::vector<Eigen::MatrixXd> informationParts(const std::vector<ValidPose>& poses) const;
  /// The sum over the poses, plus `priorInformation`.
  Eigen::MatrixXd totalInformation(const std::vector<ValidPose>& poses) const;
  /// Priors, plus the information of the kept poses.
  const Eigen::MatrixXd& priorInformation() const { return known_; }

  /// Objective to minimise; `sum`: total information of the poses. For `time`: seconds to play them, or a penalty above
  /// 1e6 if PlanOptions::sigma is not reached.
  double objective(const Eigen::MatrixXd& sum, const std::vector<ValidPose>& poses) const;
  /// Largest standard deviation of an offset of the drawn robot [rad].
  double worstSigma(const Eigen::MatrixXd& sum) const;

  /// Predicted standard deviation of each joint's offset [rad] for the drawn robot; `known`: camera mounts and board
  /// placements are known.
  std::map<std::string, double> sigmas(const std::vector<ValidPose>& poses, bool known) const;
  /// RMS of the standard deviations over 100 robots with joint errors [rad]; their images differ from the drawn
  /// robot's.
  std::map<std::string, double> perturbedSigmas(const std::vector<ValidPose>& poses) const;

private:
  /// Information of the drawn robot, plus the mean over the perturbed robots.
  Eigen::MatrixXd expectedInformation(const Eigen::MatrixXd& sum) const;
  std::vector<Eigen::MatrixXd> expectedParts(const std::vector<ValidPose>& poses) const;
  std::vector<Eigen::MatrixXd> partsOfDrawn(const std::vector<ValidPose>& poses) const;
  /// A robot's block of a sum; 0: drawn robot.
  Eigen::MatrixXd ofRobot(const Eigen::MatrixXd& sum, std::size_t robot) const;
  std::map<std::string, double> nameSigmas(const Eigen::VectorXd& variances) const;

  ThesisCriterion thesis() const;

  const Robot& robot_;
  const std::map<std::string, CameraIntrinsics>& cameras_;
  const PlanOptions& options_;
  std::vector<Board> boards_;
  PlanningScene scene_;
  std::vector<std::size_t> joints_; // whose offsets are planned for
  PoseCriterion judge_;
  std::vector<Eigen::VectorXd> perturbedErrors_; // joint errors per robot, per joint of the drawing [rad]
  std::vector<ValidPose> kept_;
  Eigen::MatrixXd known_;
};

/// Draft of a plan: poses, and boards in the support sole's frame.
struct PlanDraft {
  std::vector<ValidPose> poses;
  std::vector<Board> boards;
};

/// Local random search: perturbs a draft with decreasing step size and keeps improvements.
class PlanRefiner {
public:
  PlanRefiner(const Robot& robot, const std::map<std::string, CameraIntrinsics>& cameras, const PlanOptions& options,
              std::uint64_t seed)
      : robot_{robot}, cameras_{cameras}, options_{options}, random_{seed} {}

  /// Moves each pose in turn, within its sampling ranges; poses stay valid.
  void refinePoses(PlanDraft& draft);
  /// Moves each board in turn; boards stay at allowed places, and every pose sees one.
  void refineBoards(PlanDraft& draft);

private:
  double value(const PlanDraft& draft) const;
  double step(std::size_t attempt, std::size_t attempts);

  const Robot& robot_;
  const std::map<std::string, CameraIntrinsics>& cameras_;
  const PlanOptions& options_;
  std::mt19937_64 random_;
};

/// Optimises the selection of poses among candidates, and the boards' places, for a plan's criterion.
class PlanOptimizer {
public:
  /// `tell`: receives progress messages for display.
  PlanOptimizer(const Robot& robot, const std::map<std::string, CameraIntrinsics>& cameras, const PlanOptions& options,
                const std::function<void(const std::string&)>& tell)
      : robot_{robot}, cameras_{cameras}, options_{options}, tell_{tell} {}

  /// Starts from `boards`. The thesis's criterion and `discriminate` only select. `time` finds the quickest number of
  /// poses that reaches PlanOptions::sigma (InputError if none does). All others refine PlanOptions::starts selections
  /// and continue with the best one.
  PlanDraft optimize(const std::vector<Board>& boards, const std::vector<ValidPose>& attitudes);

private:
  PlanDraft refineFromStarts(const std::vector<Board>& boards, const std::vector<ValidPose>& attitudes);
  PlanDraft quickest(const std::vector<Board>& boards, const std::vector<ValidPose>& attitudes);
  void refine(PlanDraft& draft, std::vector<ValidPose> attitudes, const PlanOptions& options, std::uint64_t seed);
  double value(const PlanDraft& draft, const PlanOptions& options) const;
  double worstSigma(const PlanDraft& draft) const;

  const Robot& robot_;
  const std::map<std::string, CameraIntrinsics>& cameras_;
  const PlanOptions& options_;
  const std::function<void(const std::string&)>& tell_;
  std::mutex telling_;
};

} // namespace naocal
