#include "diagnose/Evidence.hpp"

#include "calibrate/JointNoise.hpp"
#include "calibrate/Tails.hpp"
#include "diagnose/LevelTests.hpp"
#include "geometry/Index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace naocal {

namespace {

double tail(double fall, Eigen::Index freedom) {
  return freedom < 1 || fall <= 0 ? 1 : chiSquaredTail(fall, static_cast<double>(freedom));
}

/// Most of the alarm's false alarms are left to the effects that have a name: there are many more curves, and for one
/// of them to raise it, it must be rarer by this factor (a weighted test: Genovese, Roeder and Wasserman 2006).
constexpr double rarer = 16;

double smallestP(const ScoreProblem& problem, const ScoreTests& tests, const Eigen::VectorXd& ratio) {
  std::map<std::pair<bool, Eigen::Index>, double> largest; // of groups that are named or not, by their freedom
  for (std::size_t i = 0; i < problem.groups.size(); ++i) {
    double& most = largest[{i < problem.named, tests.freedom(i)}];
    most = std::max(most, ratio[at(i)]);
  }
  double result = 1;
  for (const auto& [kind, most] : largest) {
    result = std::min(result, (kind.first ? 1 : rarer) * tail(most, kind.second));
  }
  return result;
}

/// 2 ln of the Bayes factor of coefficients ~ N(0, 1): |L^-1 s|^2 - 2 ln |L|, L L^T = information + 1.
double bayesOf(const Eigen::MatrixXd& information, const Eigen::VectorXd& score) {
  Eigen::MatrixXd posterior = information;
  posterior.diagonal().array() += 1;
  const Eigen::LLT<Eigen::MatrixXd> factor{posterior};
  return score.dot(factor.solve(score)) - 2 * factor.matrixLLT().diagonal().array().log().sum();
}

/// The same where the first few coefficients may suffice, all degrees as likely: the mean of their Bayes factors.
double bayesOf(const ColumnGroup& group, const Eigen::MatrixXd& information, const Eigen::VectorXd& score) {
  const Eigen::Index part = group.part > 0 ? group.part : group.count;
  std::vector<double> degrees;
  for (Eigen::Index count = part; count <= group.count; count += part) {
    degrees.push_back(bayesOf(information.topLeftCorner(count, count), score.head(count)));
  }
  const double most = *std::max_element(degrees.begin(), degrees.end());
  double mean = 0;
  for (double degree : degrees) {
    mean += std::exp((degree - most) / 2) / static_cast<double>(degrees.size());
  }
  return most + 2 * std::log(mean) - 2 * std::log(static_cast<double>(group.choices));
}

/// Estimates and Bayes factors of the measurements' groups.
void describe(const ScoreProblem& problem, LevelTests& tests, const PoseScores& measured, const NullFit& null,
              Evidence& evidence) {
  std::vector<double> bestDeviance(problem.groups.size(), std::numeric_limits<double>::infinity());
  for (std::size_t level = 0; level <= null.level.front(); ++level) {
    const double worse = null.outcomes[level].deviance[0] - null.deviance[0];
    const std::vector<ScoreTests::GroupScore> scores = tests[level].groups(measured, null.outcomes[level].own);
    for (std::size_t i = 0; i < scores.size(); ++i) {
      GroupEvidence& group = evidence.groups[i];
      const ColumnGroup& columns = problem.groups[i];
      const Eigen::VectorXd plausible = problem.plausible.segment(columns.first, columns.count);
      const Eigen::MatrixXd scaled =
          plausible.asDiagonal() * scores[i].information * plausible.asDiagonal(); // in units of the plausible
      const Eigen::VectorXd scaledScore = plausible.cwiseProduct(scores[i].score);
      const double bayes = bayesOf(columns, scaled, scaledScore) - worse;
      group.bayes = level == 0 ? bayes : std::max(group.bayes, bayes);
      Eigen::MatrixXd nearly = scaled; // a wide prior instead of none: absorbed directions stay where they are
      nearly.diagonal().array() += 1e-4;
      const Eigen::LDLT<Eigen::MatrixXd> wide{nearly};
      const Eigen::VectorXd estimate = wide.solve(scaledScore);
      const double fall = scaledScore.dot(estimate);
      if (worse - fall < bestDeviance[i]) {
        bestDeviance[i] = worse - fall;
        group.level = tests[level].noise().pose;
        group.fall = fall;
        group.keptFraction = tests[level].keptFraction(i);
        group.freedom = tests[level].freedom(i);
        group.estimate = plausible.cwiseProduct(estimate);
        group.covariance = plausible.asDiagonal() *
                           wide.solve(Eigen::MatrixXd::Identity(columns.count, columns.count)) * plausible.asDiagonal();
      }
    }
  }
}

/// The level that the best candidate effect leaves.
double bestLevel(const ScoreProblem& problem, const Evidence& evidence) {
  double level = evidence.level, most = 0;
  for (std::size_t i = 0; i < problem.named; ++i) {
    if (evidence.groups[i].bayes > most) {
      most = evidence.groups[i].bayes;
      level = evidence.groups[i].level;
    }
  }
  return level;
}

} // namespace

Evidence evidenceOf(const ScoreProblem& problem, const Noise& noise, const std::vector<double>& levels,
                    Eigen::Index draws, std::uint64_t seed) {
  const PoseScores measured = measuredScores(*problem.linear, noise);
  LevelTests tests{problem, noise, levels.empty() ? poseLevels(problem, noise, measured) : levels};
  const NullFit null = tests.nullOf(measured, problem.priorScore());
  const ScoreTests& there = tests[null.level.front()];
  Evidence result;
  result.level = there.noise().pose;
  result.withoutScatter = null.outcomes.front().deviance[0] - null.deviance[0] + scatterPenalty(result.level);
  result.groups.resize(problem.groups.size());
  const Eigen::VectorXd ratio = tests.ratios(measured, null);
  describe(problem, tests, measured, null, result);
  for (std::size_t i = 0; i < problem.groups.size(); ++i) {
    result.groups[i].likelihoodRatio = ratio[at(i)];
    result.groups[i].pValue = tail(ratio[at(i)], there.freedom(i));
  }
  result.information = tests[tests.placeOf(bestLevel(problem, result))].information();
  if (draws == 0) {
    return result;
  }
  const double observed = smallestP(problem, there, ratio);

  const PoseScores noiseOnly = drawnScores(*problem.linear, there.noise(), draws, seed);
  const NullFit nulls = tests.nullOf(noiseOnly, Eigen::VectorXd::Zero(problem.own()));
  const Eigen::MatrixXd drawn = tests.ratios(noiseOnly, nulls);
  std::vector<double> smallest;
  for (Eigen::Index i = 0; i < draws; ++i) {
    smallest.push_back(smallestP(problem, there, drawn.col(i)));
  }
  std::sort(smallest.begin(), smallest.end());
  const auto as = std::upper_bound(smallest.begin(), smallest.end(), observed) - smallest.begin();
  result.pValue = (1 + static_cast<double>(as)) / (1 + static_cast<double>(draws));
  result.criticalP = smallest[smallest.size() / 20];
  return result;
}

} // namespace naocal
