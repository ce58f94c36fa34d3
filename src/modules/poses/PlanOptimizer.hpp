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

/// What sets of poses tell of the joint offsets, with the boards where they are.
class PlanEvaluator {
public:
  PlanEvaluator(const Robot& robot, const std::vector<Board>& boards,
                const std::map<std::string, CameraIntrinsics>& cameras, const PlanOptions& options);

  const PlanningScene& scene() const { return scene_; }
  const PoseCriterion& criterion() const { return judge_; }
  /// Poses that are taken besides (PlanOptions::kept).
  const std::vector<ValidPose>& keptPoses() const { return kept_; }

  /// The best set of `count` poses that is found by the criterion; the thesis's may be smaller.
  std::vector<ValidPose> selectPoses(const std::vector<ValidPose>& candidates, std::size_t count) const;
  Interaction interaction(const std::vector<ValidPose>& poses) const;

  /// By how much chi2 the wrong one of PlanOptions::effects fits worse after these poses (EffectPairCriterion); absent
  /// where none are named.
  std::optional<double> misfit(const std::vector<ValidPose>& poses) const;

  /// Each pose's information, as far as it is judged: of the drawn robot, and beside it of
  /// PlanOptions::perturbedRobots.
  std::vector<Eigen::MatrixXd> informationParts(const std::vector<ValidPose>& poses) const;
  /// That of all of them and what is known before.
  Eigen::MatrixXd totalInformation(const std::vector<ValidPose>& poses) const;
  /// What is known before: priors, and the poses that are kept.
  const Eigen::MatrixXd& priorInformation() const { return known_; }

  /// To be made small; `sum` is that of the poses. For `time` the seconds to play them, far more where they do not
  /// reach the sigma that is asked for.
  double objective(const Eigen::MatrixXd& sum, const std::vector<ValidPose>& poses) const;
  /// Of an offset of the drawn robot, by a sum [rad].
  double worstSigma(const Eigen::MatrixXd& sum) const;

  /// Predicted standard deviation per joint's offset for the drawn robot; `known`: cameras' and boards' places are
  /// [rad].
  std::map<std::string, double> sigmas(const std::vector<ValidPose>& poses, bool known) const;
  /// The root of the mean variance over 100 robots with joint errors, whose pictures show what the drawn robot's do
  /// not.
  std::map<std::string, double> perturbedSigmas(const std::vector<ValidPose>& poses) const;

private:
  /// What the drawn robot's pictures tell, and those of worn ones on average, together.
  Eigen::MatrixXd expectedInformation(const Eigen::MatrixXd& sum) const;
  std::vector<Eigen::MatrixXd> expectedParts(const std::vector<ValidPose>& poses) const;
  std::vector<Eigen::MatrixXd> partsOfDrawn(const std::vector<ValidPose>& poses) const;
  /// The robot's part of a sum: 0 the drawn one's.
  Eigen::MatrixXd ofRobot(const Eigen::MatrixXd& sum, std::size_t robot) const;
  std::map<std::string, double> nameSigmas(const Eigen::VectorXd& variances) const;

  ThesisCriterion thesis() const;

  const Robot& robot_;
  const std::map<std::string, CameraIntrinsics>& cameras_;
  const PlanOptions& options_;
  std::vector<Board> boards_;
  PlanningScene scene_;
  PoseCriterion judge_;
  std::vector<Eigen::VectorXd> worn_; // errors per joint of the drawing [rad]
  std::vector<ValidPose> kept_;
  Eigen::MatrixXd known_;
};

/// What is being planned: poses, and boards in the support sole's frame.
struct PlanDraft {
  std::vector<ValidPose> poses;
  std::vector<Board> boards;
};

/// Moves what is drafted a little, again and again, ever less, as long as that is judged better.
class PlanRefiner {
public:
  PlanRefiner(const Robot& robot, const std::map<std::string, CameraIntrinsics>& cameras, const PlanOptions& options,
              std::uint64_t seed)
      : robot_{robot}, cameras_{cameras}, options_{options}, random_{seed} {}

  /// Each pose in turn, within the ranges that poses are drawn from; it remains valid.
  void refinePoses(PlanDraft& draft);
  /// Each board in turn; it remains where a board may lie, and every pose sees one.
  void refineBoards(PlanDraft& draft);

private:
  double value(const PlanDraft& draft) const;
  double step(std::size_t attempt, std::size_t attempts);

  const Robot& robot_;
  const std::map<std::string, CameraIntrinsics>& cameras_;
  const PlanOptions& options_;
  std::mt19937_64 random_;
};

/// Searches the poses among candidates, and the boards' places, that a plan's criterion judges best.
class PlanOptimizer {
public:
  /// `tell`: what was found on the way, for people.
  PlanOptimizer(const Robot& robot, const std::map<std::string, CameraIntrinsics>& cameras, const PlanOptions& options,
                const std::function<void(const std::string&)>& tell)
      : robot_{robot}, cameras_{cameras}, options_{options}, tell_{tell} {}

  /// Begins with the boards where they are. The thesis's criterion and `discriminate` select only; `time` takes as few
  /// poses as reach its sigma, and more as long as that saves time (InputError where there are none); all others begin
  /// PlanOptions::starts times, refine, and go on with the best.
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
