#include "inference/Prequential.hpp"

#include "inference/Evidence.hpp"
#include "inference/PoseMisfit.hpp"
#include "inference/Thresholds.hpp"
#include "math/Statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace naocal {

namespace {

/// Start of a pose: its set, and the time within that set.
std::pair<std::size_t, double> momentOf(const PoseGroup& pose, const Measurements& measurements) {
  std::pair<std::size_t, double> first{std::numeric_limits<std::size_t>::max(), 0};
  for (const EncoderSample& reading : pose.readings) {
    for (const std::size_t picture : reading.pictures) {
      const RobotSample& instant = measurements.pictures[picture].instant;
      first = std::min(first, std::pair{instant.set, instant.time.count()});
    }
  }
  return first;
}

/// Misfit between poses with one group added, and that group's 2 ln(Bayes factor).
struct Outcome {
  double bayes, chi2, freedom;
};

/// Evaluates `group` on some of the poses only.
Outcome evaluateOutcome(const ScoreProblem& problem, const Noise& noise, const std::vector<std::size_t>& poses,
                        std::size_t group) {
  std::vector<PoseRows> rows;
  for (const std::size_t pose : poses) {
    rows.push_back((*problem.poses)[pose]);
  }
  const DriverColumns none{.blocks = std::vector<std::vector<DriverColumns::Block>>(poses.size())};
  ScoreProblem part{rows, none, problem.unknowns, problem.sigmas, problem.candidates};
  part.plausible = problem.plausible;
  part.groups = {problem.groups[group]};
  part.named = 1;
  const GroupEvidence evidence = computeEvidence({part, noise}).groups.front();
  const PoseMisfit misfit = testPoseMisfit(part, noise);
  return {evidence.bayes, std::max(0.0, misfit.chi2 - evidence.likelihoodRatio), misfit.freedom};
}

} // namespace

std::vector<std::size_t> sortPosesByTime(const Measurements& measurements) {
  std::vector<std::size_t> order(measurements.poses.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return momentOf(measurements.poses[a], measurements) < momentOf(measurements.poses[b], measurements);
  });
  return order;
}

bool Prequential::predicts() const {
  return gain > threshold::predictsNext && tail > threshold::predictsTail;
}

Prequential scorePrequentially(const ScoreProblem& problem, const Noise& noise, const std::vector<std::size_t>& order,
                               std::size_t group) {
  const auto first = static_cast<std::ptrdiff_t>(order.size() - (order.size() + 4) / 5);
  if (first == 0) {
    return {.gain = 0, .tail = 0}; // one pose: nothing to predict it from
  }
  const Outcome all = evaluateOutcome(problem, noise, order, group),
                before = evaluateOutcome(problem, noise, {order.begin(), order.begin() + first}, group);
  const double freedom = std::max(1.0, all.freedom - before.freedom);
  const double usual = std::max(1.0, before.chi2 / before.freedom); // misfit that other effects cause everywhere
  return {.gain = all.bayes - before.bayes,
          .tail = fTail(std::max(0.0, all.chi2 - before.chi2) / freedom / usual, freedom, before.freedom)};
}

} // namespace naocal
