#pragma once

#include "poses/PoseCandidates.hpp"
#include "poses/PoseCriterion.hpp"
#include "poses/ThesisSelection.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

struct PlanOptions {
  PoseOptions poses; // count: to select; tries: candidates
  Criterion criterion = Criterion::worst;
  std::map<std::string, double> weights; // of joints and cameras in the thesis's criterion, 1 where it has none
  bool compare = false;                  // all criteria on the same candidates
  Noise noise;
  std::vector<std::string> effects; // two labels, that `discriminate` tells apart
  std::size_t wornRobots = 0;       // with joint errors, for which poses and boards are judged besides
  bool known = false;               // cameras and boards: their places are not to be estimated
  bool moveBoards = true;           // else they lie where they are given
  bool mirrored = false;            // boards lie symmetrically to the middle between the feet, for both feet's poses
  double sigma = radians(0.2);      // that `time` must reach [rad]
  double secondsPerPose = 1;        // to come to rest and take pictures [s]
  std::vector<Eigen::VectorXd> kept = {}; // angles of poses that are taken besides [rad]
  double farthestBoard = 1.3;             // middle of a board from the support sole [m]
  double gap = 0.02;                      // between boards, and from the robot's feet [m]
  std::size_t weighed = 2000;             // candidates at most that are selected from, evenly among those found
  std::size_t starts = 4;                 // plans that are begun in different ways and refined; the best goes on
  std::size_t rounds = 3;                 // of refining poses and boards twice, the first for every start
  std::size_t refinements = 1000;         // tries per pose and per board in a round
};

/// What sets of poses tell of the joint offsets, with the boards where they are.
class PlanScore {
public:
  PlanScore(const Robot& robot, const std::vector<Board>& boards,
            const std::map<std::string, CameraIntrinsics>& cameras, const PlanOptions& options);

  const Scene& scene() const { return scene_; }
  const PoseJudge& judge() const { return judge_; }
  /// Poses that are taken besides (PlanOptions::kept).
  const std::vector<SievedPose>& kept() const { return kept_; }

  /// The best set of `count` poses that is found by the criterion; the thesis's may be smaller.
  std::vector<SievedPose> best(const std::vector<SievedPose>& candidates, std::size_t count) const;
  Interaction interaction(const std::vector<SievedPose>& poses) const;

  /// By how much chi2 the wrong one of PlanOptions::effects fits worse after these poses (TellingApart); absent where
  /// none are named.
  std::optional<double> misfit(const std::vector<SievedPose>& poses) const;

  /// Each pose's information, as far as it is judged: of the drawn robot, and beside it of PlanOptions::wornRobots.
  std::vector<Eigen::MatrixXd> parts(const std::vector<SievedPose>& poses) const;
  /// That of all of them and what is known before.
  Eigen::MatrixXd sum(const std::vector<SievedPose>& poses) const;
  /// What is known before: priors, and the poses that are kept.
  const Eigen::MatrixXd& known() const { return known_; }

  /// To be made small; `sum` is that of the poses. For `time` the seconds to play them, far more where they do not
  /// reach the sigma that is asked for.
  double value(const Eigen::MatrixXd& sum, const std::vector<SievedPose>& poses) const;
  /// Of an offset of the drawn robot, by a sum [rad].
  double worstSigma(const Eigen::MatrixXd& sum) const;

  /// Predicted standard deviation per joint's offset for the drawn robot; `known`: cameras' and boards' places are
  /// [rad].
  std::map<std::string, double> sigmas(const std::vector<SievedPose>& poses, bool known) const;
  /// The root of the mean variance over 100 robots with joint errors, whose pictures show what the drawn robot's do
  /// not.
  std::map<std::string, double> sigmasOfRobots(const std::vector<SievedPose>& poses) const;

private:
  /// What the drawn robot's pictures tell, and those of worn ones on average, together.
  Eigen::MatrixXd expected(const Eigen::MatrixXd& sum) const;
  std::vector<Eigen::MatrixXd> expectedParts(const std::vector<SievedPose>& poses) const;
  std::vector<Eigen::MatrixXd> partsOfDrawn(const std::vector<SievedPose>& poses) const;
  /// The robot's part of a sum: 0 the drawn one's.
  Eigen::MatrixXd ofRobot(const Eigen::MatrixXd& sum, std::size_t robot) const;
  std::map<std::string, double> named(const Eigen::VectorXd& variances) const;

  ThesisSelection thesis() const;

  const Robot& robot_;
  const std::map<std::string, CameraIntrinsics>& cameras_;
  const PlanOptions& options_;
  std::vector<Board> boards_;
  Scene scene_;
  PoseJudge judge_;
  std::vector<Eigen::VectorXd> worn_; // errors per joint of the drawing [rad]
  std::vector<SievedPose> kept_;
  Eigen::MatrixXd known_;
};

} // namespace naocal
