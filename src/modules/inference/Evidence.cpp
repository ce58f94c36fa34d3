#include "inference/Evidence.hpp"

#include "inference/NoiseLevels.hpp"
#include "inference/Thresholds.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/Statistics.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace naocal {

namespace {

double tail(double fall, Eigen::Index freedom) {
  return freedom < 1 || fall <= 0 ? 1 : chiSquaredTail(fall, static_cast<double>(freedom));
}

double smallestP(const ScoreProblem& problem, const ScoreTest& tests, const Eigen::VectorXd& ratio) {
  std::map<std::pair<bool, Eigen::Index>, double> largest; // largest ratio by (named, degrees of freedom)
  for (std::size_t i = 0; i < problem.groups.size(); ++i) {
    double& most = largest[{i < problem.named, tests.degreesOfFreedom(i)}];
    most = std::max(most, ratio[eigenIndex(i)]);
  }
  double result = 1;
  for (const auto& [kind, most] : largest) {
    result = std::min(result, (kind.first ? 1 : threshold::curveRarity) * tail(most, kind.second));
  }
  return result;
}

/// Upper bound (Bonferroni) on the probability that pure noise shows a `smallestP` this small.
double boundChance(const ScoreProblem& problem, double smallest) {
  const auto named = static_cast<double>(problem.named), all = static_cast<double>(problem.groups.size());
  return smallest * (named + (all - named) / threshold::curveRarity);
}

/// 2 ln(Bayes factor) of a group. For a smooth curve, the mean over its degrees, all equally likely a priori.
double groupBayesFactor(const ColumnGroup& group, const Eigen::MatrixXd& information, const Eigen::VectorXd& score) {
  if (group.count == 0) { // nothing that there could be evidence for
    return 0;
  }
  const Eigen::Index part = group.part > 0 ? group.part : group.count;
  std::vector<double> degrees;
  for (Eigen::Index count = part; count <= group.count; count += part) {
    degrees.push_back(computeBayesFactor(information.topLeftCorner(count, count), score.head(count)));
  }
  const double most = *std::max_element(degrees.begin(), degrees.end());
  double mean = 0;
  for (double degree : degrees) {
    mean += std::exp((degree - most) / 2) / static_cast<double>(degrees.size());
  }
  return most + 2 * std::log(mean) - 2 * std::log(static_cast<double>(group.choices));
}

/// Further decrease of chi2 when `added` joins `other`.
double fallBeside(const MeasuredTests& measured, const ColumnGroup& added, const ColumnGroup& other) {
  const auto fall = [&](const std::vector<Eigen::Index>& columns) {
    const Eigen::VectorXd plausible = measured.alone.problem().plausible(columns),
                          score = plausible.cwiseProduct(measured.scores(columns));
    Eigen::MatrixXd scaled =
        plausible.asDiagonal() * measured.tests.information()(columns, columns) * plausible.asDiagonal();
    scaled.diagonal().array() += 1e-4; // regularises directions that the own unknowns absorb
    return score.dot(scaled.ldlt().solve(score));
  };
  std::vector<Eigen::Index> columns(static_cast<std::size_t>(other.count));
  std::iota(columns.begin(), columns.end(), other.first);
  const double alone = fall(columns);
  for (Eigen::Index i = 0; i < added.count; ++i) {
    columns.push_back(added.first + i);
  }
  return fall(columns) - alone;
}

/// Estimate and Bayes factor of group `i`.
GroupEvidence describeGroup(const MeasuredTests& measured, std::size_t i) {
  const ScoreProblem& problem = measured.alone.problem();
  const ScoreTest& tests = measured.tests;
  const ColumnGroup& columns = problem.groups[i];
  const Eigen::VectorXd plausible = problem.plausible.segment(columns.first, columns.count);
  Eigen::MatrixXd scaled = plausible.asDiagonal() * tests.informationOf(i) * plausible.asDiagonal();
  const Eigen::VectorXd scaledScore = plausible.cwiseProduct(measured.scores.segment(columns.first, columns.count));
  GroupEvidence group;
  group.bayes = groupBayesFactor(columns, scaled, scaledScore);
  scaled.diagonal().array() += 1e-4; // wide prior; keeps absorbed directions at zero
  const Eigen::LDLT<Eigen::MatrixXd> wide{scaled};
  group.keptFraction = tests.keptFraction(i);
  group.freedom = tests.degreesOfFreedom(i);
  group.estimate = plausible.cwiseProduct(wide.solve(scaledScore));
  group.covariance = plausible.asDiagonal() * wide.solve(Eigen::MatrixXd::Identity(columns.count, columns.count)) *
                     plausible.asDiagonal();
  if (group.bayes > 0 && columns.first < problem.candidates) {
    group.movedPx = tests.movedPx(i, group.estimate);
  }
  return group;
}

/// Index of the group with the largest Bayes factor among those from `first` on, if any; sets its `movedPx`.
std::optional<std::size_t> measureLikeliest(const ScoreTest& tests, std::size_t first,
                                            std::vector<GroupEvidence>& groups) {
  const auto found = std::max_element(groups.begin() + static_cast<std::ptrdiff_t>(first), groups.end(),
                                      [](const GroupEvidence& a, const GroupEvidence& b) { return a.bayes < b.bayes; });
  if (found == groups.end()) {
    return std::nullopt;
  }
  const auto index = static_cast<std::size_t>(found - groups.begin());
  found->movedPx = tests.movedPx(index, found->estimate);
  return index;
}

/// Whether a likely, significant group matters: the likeliest, or a named one beside it. True if no group is likely.
bool anyMatters(const MeasuredTests& measured, const std::vector<GroupEvidence>& groups, std::size_t likeliest) {
  const ScoreProblem& problem = measured.alone.problem();
  if (groups[likeliest].bayes <= 0 || groups[likeliest].matters()) {
    return true;
  }
  for (std::size_t i = 0; i < problem.named && likeliest < problem.named; ++i) {
    const bool likely = i != likeliest && groups[i].bayes > 2 * std::log(static_cast<double>(problem.named));
    if (likely && groups[i].matters() &&
        boundChance(problem, tail(fallBeside(measured, problem.groups[i], problem.groups[likeliest]),
                                  groups[i].freedom)) <= threshold::alarm) {
      return true;
    }
  }
  return false;
}

/// Sets of pure noise and their outcomes under the model without candidates.
struct DrawnSets {
  PoseResiduals residuals;
  NullModel::Outcome outcome;
};

/// Whether each set estimates the pose noise at its boundary, zero (`isPoseNoiseAtBoundary`). Pure noise puts the scale
/// kappa of candidates at zero, so the deviance is that of the model without them.
Eigen::Array<bool, 1, Eigen::Dynamic> findBoundarySets(const NullModel& alone, const DrawnSets& drawn) {
  const ScoreProblem& problem = alone.problem();
  Noise least = alone.noise();
  least.pose = leastScatter;
  const Eigen::RowVectorXd scattered =
      NullModel{problem, least}(drawn.residuals, Eigen::VectorXd::Zero(problem.ownCount())).deviance;
  return drawn.outcome.deviance.array() <= scattered.array() + poseNoisePenalty(leastScatter);
}

/// Indices of the sets that the data are compared with (`computeEvidence`).
std::vector<Eigen::Index> selectComparable(const NullModel& alone, const DrawnSets& drawn) {
  constexpr std::size_t fewest = 20; // for a critical value at 5 %
  std::vector<Eigen::Index> all(static_cast<std::size_t>(drawn.outcome.deviance.size()));
  std::iota(all.begin(), all.end(), Eigen::Index{0});
  if (alone.noise().pose > 0) {
    return all;
  }
  const bool atBoundary = isPoseNoiseAtBoundary(alone.problem(), alone.noise());
  const auto areAtBoundary = findBoundarySets(alone, drawn);
  std::vector<Eigen::Index> alike;
  std::copy_if(all.begin(), all.end(), std::back_inserter(alike),
               [&](Eigen::Index i) { return areAtBoundary[i] == atBoundary; });
  return alike.size() < fewest ? all : alike;
}

/// `smallestP` of the sets of pure noise that the data are compared with, in ascending order: parametric bootstrap.
std::vector<double> drawSmallestP(const MeasuredTests& measured, Eigen::Index draws, std::uint64_t seed) {
  const NullModel& alone = measured.alone;
  const ScoreProblem& problem = alone.problem();
  DrawnSets drawn{drawResiduals(*problem.poses, alone.noise(), draws, seed), {}};
  drawn.outcome = alone(drawn.residuals, Eigen::VectorXd::Zero(problem.ownCount()));
  const Eigen::MatrixXd falls = measured.tests.chi2Decreases(drawn.residuals, drawn.outcome.own);
  std::vector<double> smallest;
  for (const Eigen::Index i : selectComparable(alone, drawn)) {
    smallest.push_back(smallestP(problem, measured.tests, falls.col(i)));
  }
  std::sort(smallest.begin(), smallest.end());
  return smallest;
}

} // namespace

double computeBayesFactor(const Eigen::MatrixXd& information, const Eigen::VectorXd& score) {
  double most = 0, sum = 0;
  for (const auto& [width, odds] : plausibleWidths) {
    Eigen::MatrixXd posterior = information;
    posterior.diagonal().array() += 1 / (width * width);
    const Eigen::LLT<Eigen::MatrixXd> factor{posterior};
    const double bayes = score.dot(factor.solve(score)) - 2 * factor.matrixLLT().diagonal().array().log().sum() -
                         2 * static_cast<double>(score.size()) * std::log(width) + 2 * std::log(odds);
    const double larger = sum == 0 ? bayes : std::max(most, bayes);
    sum = sum * std::exp((most - larger) / 2) + std::exp((bayes - larger) / 2);
    most = larger;
  }
  return most + 2 * std::log(sum);
}

Evidence computeEvidence(const MeasuredTests& measured, Eigen::Index draws, std::uint64_t seed) {
  const ScoreProblem& problem = measured.alone.problem();
  const ScoreTest& tests = measured.tests;
  const Eigen::VectorXd ratio = tests.chi2Decreases(measured.residuals, measured.outcome.own);
  Evidence result;
  for (std::size_t i = 0; i < problem.groups.size(); ++i) {
    GroupEvidence& group = result.groups.emplace_back(describeGroup(measured, i));
    group.likelihoodRatio = ratio[eigenIndex(i)];
    group.pValue = tail(ratio[eigenIndex(i)], tests.degreesOfFreedom(i));
  }
  measureLikeliest(tests, problem.named, result.groups); // a curve
  if (const auto likeliest = measureLikeliest(tests, 0, result.groups)) {
    result.matters = anyMatters(measured, result.groups, *likeliest);
    result.likeliest = result.groups[*likeliest].bayes > 0 ? likeliest : std::nullopt;
  }
  result.information = tests.information();
  if (draws == 0) {
    return result;
  }
  const std::vector<double> smallest = drawSmallestP(measured, draws, seed);
  const double seen = smallestP(problem, tests, ratio);
  const auto as = std::upper_bound(smallest.begin(), smallest.end(), seen) - smallest.begin();
  result.pValue = (1 + static_cast<double>(as)) / (1 + static_cast<double>(smallest.size()));
  if (as == 0) { // more extreme than every draw
    result.pValue = std::min(result.pValue, boundChance(problem, seen));
  }
  result.criticalP = smallest[smallest.size() / 20];
  return result;
}

} // namespace naocal
