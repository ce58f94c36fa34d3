#include "evaluation/NextPosesTrial.hpp"

#include "diagnosis/Diagnosis.hpp"
#include "estimation/ModelBuilder.hpp"
#include "poses/NextPoses.hpp"
#include "simulation/Simulation.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace naocal {

namespace {

/// Stable poses as they come, not chosen for what they tell.
std::vector<CommandedPose> randomPoses(const Robot& robot, std::size_t count, std::uint64_t seed) {
  PoseOptions options;
  options.count = count;
  options.seed = seed;
  options.choice = 1;
  SimulationPlan plan;
  for (Board& board : plan.boards) {
    board.placement->y -= halfStance;
  }
  std::vector<CommandedPose> result;
  for (PlannedPose& pose : stablePoses(robot, plan.boards, plan.cameras, options)) {
    result.push_back({fmt::format("P{:02}", result.size()), pose.supportFoot, std::move(pose.angles)});
  }
  return result;
}

std::vector<CommandedPose> commanded(const std::vector<ProposedPose>& poses) {
  std::vector<CommandedPose> result;
  for (const ProposedPose& pose : poses) {
    result.push_back({fmt::format("N{:02}", result.size()), pose.pose.supportFoot, pose.pose.angles, pose.approach});
  }
  return result;
}

/// The robot of a trial: takes poses in one stance after the other.
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

/// The class weighed by all captures so far.
struct Weighed {
  Model model;
  CalibrationResult fit;
  OpenQuestion question;
};

Weighed weighed(const Measurements& measurements, OpenQuestion question) {
  const Model model = makeModel(measurements, question.with, question.without, question.effects);
  CalibrationResult fit = calibrate(measurements, model);
  std::vector<Term> terms;
  for (const Suspect& suspect : question.suspects) {
    for (Term& term : candidateTerms(measurements, question.effects)) {
      if (term.label() == suspect.label) {
        terms.push_back(std::move(term));
      }
    }
  }
  InquiryOptions options;
  options.draws = 0;
  options.map = false;
  const Inquiry inquiry{measurements, model, fit, terms, options};
  std::vector<double> evidence;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    evidence.push_back(inquiry.ofCandidate(i).bayes);
    question.suspects[i].size = inquiry.ofCandidate(i).estimate;
  }
  const std::vector<double> odds = probabilities(evidence);
  for (std::size_t i = 0; i < odds.size(); ++i) {
    question.suspects[i].odds = odds[i];
  }
  return {model, std::move(fit), std::move(question)};
}

const Suspect& likeliest(const Weighed& weighed) {
  const std::vector<Suspect>& suspects = weighed.question.suspects;
  return *std::max_element(suspects.begin(), suspects.end(),
                           [](const Suspect& a, const Suspect& b) { return a.odds < b.odds; });
}

/// The first captures of a set's poses, as many poses as wanted.
CaptureSet firstPoses(CaptureSet set, const std::vector<CommandedPose>& poses, std::size_t count) {
  std::erase_if(set.captures, [&](const Capture& capture) {
    return std::none_of(poses.begin(), poses.begin() + static_cast<std::ptrdiff_t>(count),
                        [&](const CommandedPose& pose) { return pose.name == capture.pose; });
  });
  return set;
}

NextTrialArm arm(const Robot& robot, const Subject& subject, const CaptureSet& start, const OpenQuestion& question,
                 const std::string& hidden, bool propose, std::uint64_t seed, const NextTrialOptions& options) {
  std::vector<CaptureSet> sets{start};
  for (std::size_t taken = 0; taken < options.most; taken += options.batch) {
    const Measurements measurements = measurementsOf(sets, robot, true);
    const Weighed now = weighed(measurements, question);
    NextOptions next;
    next.count = options.batch;
    next.seed = 1000 * seed + taken;
    next.samePlace = true;
    const std::vector<CommandedPose> poses =
        propose
            ? commanded(
                  nextPoses(sets, measurements, {now.model, now.fit.unknowns, now.fit.noise}, now.question, next).poses)
            : randomPoses(robot, options.batch, next.seed + 1);
    const CaptureSet captures = subject.captures(poses, sets.size()).set;
    sets.emplace_back();
    for (std::size_t count = 1; count <= poses.size(); ++count) {
      sets.back() = firstPoses(captures, poses, count);
      const Weighed then = weighed(measurementsOf(sets, robot, true), question);
      if (likeliest(then).odds >= options.certainty) {
        return {taken + count, likeliest(then).label == hidden};
      }
    }
  }
  return {};
}

} // namespace

NextTrial nextTrial(const Robot& robot, std::uint64_t seed, const NextTrialOptions& options) {
  const Subject subject{robot, seed, options.flawScale};
  const Simulation start = subject.captures(randomPoses(robot, options.start, seed), 0);
  const Measurements measurements = measurementsOf({start.set}, robot);
  const DiagnosisOptions asked;
  const Diagnosis diagnosis = diagnose({start.set}, measurements, asked);
  const OpenQuestion question = openQuestion(diagnosis, robot, asked);
  const TrueEffect& hidden = start.truth.effects.back();
  NextTrial result{seed, hidden.effect + "@" + hidden.at, {}, {}, {}};
  if (diagnosis.verdict != Verdict::effectMissing || !question.rivals ||
      likeliest(weighed(measurements, question)).odds >= options.certainty) {
    return result;
  }
  for (const Suspect& suspect : question.suspects) {
    result.suspects.push_back(suspect.label);
  }
  result.proposed = arm(robot, subject, start.set, question, result.hidden, true, seed, options);
  result.random = arm(robot, subject, start.set, question, result.hidden, false, seed, options);
  return result;
}

} // namespace naocal
