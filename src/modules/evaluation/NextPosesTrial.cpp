#include "evaluation/NextPosesTrial.hpp"

#include "diagnosis/Diagnosis.hpp"
#include "estimation/CandidateTerms.hpp"
#include "estimation/ModelBuilder.hpp"
#include "poses/NextPoses.hpp"
#include "simulation/Simulation.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace naocal {

namespace {

/// Random stable poses, not selected by information.
std::vector<CommandedPose> randomPoses(const Robot& robot, std::size_t count, std::uint64_t seed) {
  PoseOptions options;
  options.count = count;
  options.seed = seed;
  options.choice = 1;
  SimulationPlan plan;
  for (Board& board : plan.boards) {
    board.placement->y -= halfFootDistance;
  }
  std::vector<CommandedPose> result;
  for (PlannedPose& pose : planInformativePoses(robot, plan.boards, plan.cameras, options)) {
    result.push_back({fmt::format("P{:02}", result.size()), pose.supportFoot, std::move(pose.angles)});
  }
  return result;
}

std::vector<CommandedPose> commandPoses(const std::vector<ProposedPose>& poses) {
  std::vector<CommandedPose> result;
  for (const ProposedPose& pose : poses) {
    result.push_back({fmt::format("N{:02}", result.size()), pose.pose.supportFoot, pose.pose.angles, pose.approach});
  }
  return result;
}

/// The robot of a trial; each batch of poses is one stance.
class Subject {
public:
  Subject(const Robot& robot, std::uint64_t seed, double flawScale)
      : robot_{robot}, seed_{seed}, flawScale_{flawScale} {}

  Simulation captures(std::vector<CommandedPose> poses, std::size_t stance) const {
    SimulationPlan plan;
    plan.poses = std::move(poses);
    plan.repeatKind = RepeatKind::reapproach;
    plan.hiddenFlaw = true;
    plan.flawScale = flawScale_;
    plan.robotSeed = plan.boardSeed = seed_;
    plan.firstStance = static_cast<int>(stance);
    return simulate(robot_, plan, 1000 * seed_ + stance);
  }

private:
  const Robot& robot_;
  std::uint64_t seed_;
  double flawScale_;
};

/// The class, weighed by all captures so far.
struct Weighed {
  Model model;
  CalibrationResult fit;
  ModelAmbiguity question;
};

Weighed weighHypotheses(const Measurements& measurements, ModelAmbiguity question) {
  const Model model = buildModel(measurements, question.with, question.without, question.effects);
  CalibrationResult fit = calibrate(measurements, model);
  std::vector<Term> terms;
  for (const Hypothesis& suspect : question.suspects) {
    for (Term& term : candidateTerms(measurements, question.effects)) {
      if (term.label() == suspect.label) {
        terms.push_back(std::move(term));
      }
    }
  }
  CandidateTestOptions options;
  options.draws = 0;
  options.map = false;
  const CandidateTests candidateTests{{measurements, model, fit}, terms, options};
  std::vector<double> evidence;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    evidence.push_back(candidateTests.candidateEvidence(i).bayes);
    question.suspects[i].size = candidateTests.candidateEvidence(i).estimate;
  }
  const std::vector<double> odds = posteriorProbabilities(evidence);
  for (std::size_t i = 0; i < odds.size(); ++i) {
    question.suspects[i].odds = odds[i];
  }
  return {model, std::move(fit), std::move(question)};
}

const Hypothesis& findLikeliest(const Weighed& weighed) {
  const std::vector<Hypothesis>& suspects = weighed.question.suspects;
  return *std::max_element(suspects.begin(), suspects.end(),
                           [](const Hypothesis& a, const Hypothesis& b) { return a.odds < b.odds; });
}

/// The captures of a set's first `count` poses.
CaptureSet firstPoses(CaptureSet set, const std::vector<CommandedPose>& poses, std::size_t count) {
  std::erase_if(set.captures, [&](const Capture& capture) {
    return std::none_of(poses.begin(), poses.begin() + static_cast<std::ptrdiff_t>(count),
                        [&](const CommandedPose& pose) { return pose.name == capture.pose; });
  });
  return set;
}

/// What both arms of a trial start from.
struct TrialStart {
  const Robot& robot;
  const Subject& subject;
  const CaptureSet& captures;
  const ModelAmbiguity& question;
  std::string hidden; // the true effect's label
  std::uint64_t seed;
};

/// Adds poses, proposed or random, until one effect of the class is all but certain.
TrialArm runArm(const TrialStart& start, bool propose, const NextPosesTrialOptions& options) {
  std::vector<CaptureSet> sets{start.captures};
  for (std::size_t taken = 0; taken < options.most; taken += options.batch) {
    const Measurements measurements = buildMeasurements(sets, start.robot, true);
    const Weighed now = weighHypotheses(measurements, start.question);
    NextPosesOptions next;
    next.count = options.batch;
    next.seed = 1000 * start.seed + taken;
    const std::vector<CommandedPose> poses =
        propose ? commandPoses(proposeNextPoses({measurements, now.model, now.fit}, now.question, next).poses)
                : randomPoses(start.robot, options.batch, next.seed + 1);
    const CaptureSet captures = start.subject.captures(poses, sets.size()).set;
    sets.emplace_back();
    for (std::size_t count = 1; count <= poses.size(); ++count) {
      sets.back() = firstPoses(captures, poses, count);
      const Weighed then = weighHypotheses(buildMeasurements(sets, start.robot, true), start.question);
      if (findLikeliest(then).odds >= options.certainty) {
        return {taken + count, findLikeliest(then).label == start.hidden};
      }
    }
  }
  return {};
}

} // namespace

NextPosesTrial runNextPosesTrial(const Robot& robot, std::uint64_t seed, const NextPosesTrialOptions& options) {
  const Subject subject{robot, seed, options.flawScale};
  const Simulation start = subject.captures(randomPoses(robot, options.start, seed), 0);
  const Measurements measurements = buildMeasurements({start.set}, robot);
  const DiagnosisOptions asked;
  const Diagnosis diagnosis = diagnose(measurements, asked);
  const ModelAmbiguity question = findAmbiguity(diagnosis, robot, asked);
  const TrueEffect& hidden = start.truth.effects.back();
  NextPosesTrial result{seed, hidden.effect + "@" + hidden.at, {}, {}, {}};
  if (diagnosis.verdict != Verdict::effectMissing || !question.rivals ||
      findLikeliest(weighHypotheses(measurements, question)).odds >= options.certainty) {
    return result;
  }
  for (const Hypothesis& suspect : question.suspects) {
    result.suspects.push_back(suspect.label);
  }
  const TrialStart both{robot, subject, start.set, question, result.hidden, seed};
  result.proposed = runArm(both, true, options);
  result.random = runArm(both, false, options);
  return result;
}

} // namespace naocal
