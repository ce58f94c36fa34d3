#include "poses/NextPoses.hpp"

#include "estimation/ModelBuilder.hpp"
#include "math/Checkpoints.hpp"
#include "poses/candidates/SingleSupportPlanner.hpp"
#include "poses/criteria/Discrimination.hpp"
#include "poses/criteria/PlannedInformation.hpp"
#include "robot/LegKinematics.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <random>

namespace naocal {

namespace {

/// Random poses of the drawn robot in sight of the boards, with random approaches; with `bothWays` each pose is
/// repeated with the opposite approach.
std::vector<ProposedPose> candidates(const Robot& robot, const CaptureSet& set, const std::vector<LocalScene>& around,
                                     bool bothWays, const NextPosesOptions& options) {
  std::mt19937_64 random{options.seed};
  std::vector<ProposedPose> result;
  for (const LocalScene& here : around) {
    PoseOptions wanted;
    wanted.supportFoot = here.supportFoot;
    wanted.seed = options.seed;
    wanted.maxAttempts = 400 * options.candidates;
    wanted.stability.jointError = options.jointError;
    const PlanningScene scene{robot, here.supportFoot, here.boards, set.cameras, wanted.sight};
    for (const ModelState& modelState : sampleStableStates(robot, scene, wanted, options.candidates / around.size())) {
      ProposedPose pose{{here.supportFoot, modelState.values.head(static_cast<Eigen::Index>(robot.joints.size())), {}},
                        drawApproach(robot, random)};
      result.push_back(pose);
      if (bothWays) {
        pose.approach = -pose.approach;
        result.push_back(std::move(pose));
      }
    }
  }
  return result;
}

/// Greedily selects reachable poses of the largest gain, each given the previous ones; adds their information to
/// `known`.
std::vector<std::size_t> greedily(const Discrimination& discrimination, const PlannedInformation& information,
                                  const std::vector<ProposedPose>& poses,
                                  const std::function<bool(const ProposedPose&)>& isReachable, std::size_t count,
                                  Eigen::MatrixXd& known) {
  const Eigen::VectorXd before = discrimination.misfits(known);
  std::vector<std::size_t> chosen, left(poses.size());
  std::iota(left.begin(), left.end(), 0);
  while (chosen.size() < count && !left.empty()) {
    double best = -1;
    std::size_t next = 0;
    for (const std::size_t i : left) {
      Checkpoints::reach();
      Eigen::MatrixXd with = known;
      information.promised[i].addTo(with);
      if (const double gain = discrimination.expectedGain(before, discrimination.misfits(with)); gain > best) {
        best = gain;
        next = i;
      }
    }
    std::erase(left, next);
    if (isReachable(poses[next])) { // tested last, because planning ways is slow
      information.promised[next].addTo(known);
      chosen.push_back(next);
    }
  }
  return chosen;
}

std::map<std::string, double> offsetSigmas(const Model& model, const Eigen::MatrixXd& information) {
  const auto own = static_cast<Eigen::Index>(model.unknownCount());
  const Eigen::MatrixXd covariance =
      information.topLeftCorner(own, own).llt().solve(Eigen::MatrixXd::Identity(own, own));
  std::map<std::string, double> result;
  for (const std::size_t offset : model.offsets()) {
    const Term& term = model.terms()[offset];
    const auto at = static_cast<Eigen::Index>(term.first);
    if (term.requested) {
      result[term.placeName] = std::sqrt(covariance(at, at));
    }
  }
  return result;
}

} // namespace

void selectNextPoses(const ModelAmbiguity& question, const PlannedInformation& information,
                     const std::vector<ProposedPose>& planned,
                     const std::function<bool(const ProposedPose&)>& isReachable, const NextPosesOptions& options,
                     NextPoses& result) {
  const Discrimination discrimination{question, static_cast<Eigen::Index>(information.own.unknownCount())};
  Eigen::MatrixXd known = information.known;
  for (const std::size_t chosen : greedily(discrimination, information, planned, isReachable, options.count, known)) {
    result.poses.push_back(planned[chosen]);
  }
  result.growth = discrimination.growthFactor(discrimination.misfits(information.known), discrimination.misfits(known));
  result.predictedSigma = offsetSigmas(information.own, known);
  std::mt19937_64 random{options.seed};
  std::shuffle(result.poses.begin(), result.poses.end(), random);
}

NextPoses proposeNextPoses(const FittedModel& fitted, const ModelAmbiguity& question, const NextPosesOptions& options) {
  const Measurements& measurements = fitted.measurements;
  NextPoses result;
  result.why = question.why;
  if (question.suspects.empty()) {
    result.whyNone = question.whyNone;
    return result;
  }
  const Robot& robot = measurements.robot;
  if (!hasPlannableLegs(robot)) {
    result.whyNone = "poses are planned for NAOs only";
    return result;
  }
  result.around = findLocalScenes(fitted);
  if (result.around.empty()) {
    result.whyNone = "no board lies on the floor before a standing robot";
  }
  if (result.around.empty() || options.count == 0) {
    return result;
  }
  const bool bothWays = dependsOnApproach(addHypotheses(measurements, fitted.model, question));
  const std::vector<ProposedPose> drawn =
      candidates(robot, measurements.sets->back(), result.around, bothWays, options);
  const std::vector<ProposedPose> poses = filterFeasible(fitted, result.around, drawn);
  if (poses.empty()) {
    result.whyNone = "no stable pose was found that sees a board";
    return result;
  }
  result.stable = drawn.size() / (bothWays ? 2 : 1);
  result.seeing = poses.size() / (bothWays ? 2 : 1);
  result.jointError = options.jointError;
  result.noise = fitted.fit.noise;
  result.firstStance = plannedStanceId(*measurements.sets, SupportFoot::left);
  result.samples = samplesPerPose(measurements);

  ReachabilityCheck isReachable{robot, options.jointError};
  selectNextPoses(question, predictInformation(fitted, question, result.around, poses), poses, std::ref(isReachable),
                  options, result);
  return result;
}

std::string whatTheyTell(const NextPoses& next) {
  if (next.growth < worthTaking) {
    return fmt::format(
        "They hardly help: with them the evidence for or against becomes {:.2f} times as strong. More "
        "captures of the same kind, or another place of the camera, the boards or the tracker, tell more.",
        next.growth);
  }
  return fmt::format("With them the evidence for or against becomes {:.1f} times stronger.", next.growth);
}

std::string howToTake(const NextPoses& next) {
  const char* const leave = next.around.empty() ? "everything where it stands" : "the boards where they lie";
  return fmt::format("Leave {}, record the poses as a new set with \"stance\": {}", leave, next.firstStance);
}

} // namespace naocal
