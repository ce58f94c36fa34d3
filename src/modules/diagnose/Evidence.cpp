#include "diagnose/Evidence.hpp"
#include "geometry/Angles.hpp"
#include "geometry/Index.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <limits>
#include <numeric>

namespace naocal {

namespace {

double tail(double fall, Eigen::Index freedom) {
  return freedom < 1 || fall <= 0
             ? 1
             : boost::math::cdf(complement(boost::math::chi_squared{static_cast<double>(freedom)}, fall));
}

/// Of each column, the likeliest level and -2 ln likelihood there.
struct Null {
  std::vector<std::size_t> level;
  Eigen::RowVectorXd deviance;
};

Null nullOf(const std::vector<ScoreTests>& tests, const PoseScores& scores, const Eigen::VectorXd& priorScore) {
  Null result{std::vector<std::size_t>(static_cast<std::size_t>(scores.front().unknowns.cols()), 0), {}};
  for (std::size_t level = 0; level < tests.size(); ++level) {
    const Eigen::RowVectorXd here = tests[level].modelAlone(scores, priorScore).deviance;
    if (level == 0) {
      result.deviance = here;
    }
    for (Eigen::Index i = 0; i < here.size(); ++i) {
      if (here[i] < result.deviance[i]) {
        result.deviance[i] = here[i];
        result.level[static_cast<std::size_t>(i)] = level;
      }
    }
  }
  return result;
}

PoseScores columns(const PoseScores& scores, const std::vector<Eigen::Index>& which) {
  PoseScores result;
  for (const PoseScore& pose : scores) {
    result.push_back({pose.unknowns(Eigen::all, which), pose.deflections(Eigen::all, which)});
  }
  return result;
}

/// Likelihood ratio of every group (row) for every set of scores (column). A group can only lower the pose noise, so
/// that levels above the null's need not be tried.
Eigen::MatrixXd ratios(const std::vector<ScoreTests>& tests, const PoseScores& scores,
                       const Eigen::VectorXd& priorScore, const Null& null, std::size_t groups) {
  const Eigen::Index draws = null.deviance.size();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(at(groups), draws);
  for (std::size_t level = 0; level < tests.size(); ++level) {
    std::vector<Eigen::Index> which;
    for (Eigen::Index i = 0; i < draws; ++i) {
      if (null.level[static_cast<std::size_t>(i)] >= level) {
        which.push_back(i);
      }
    }
    if (which.empty()) {
      break;
    }
    const ScoreTests::Outcome outcome = tests[level](columns(scores, which), priorScore);
    for (std::size_t i = 0; i < which.size(); ++i) {
      const double worse = outcome.deviance[at(i)] - null.deviance[which[i]];
      result.col(which[i]) = result.col(which[i]).cwiseMax((outcome.falls.col(at(i)).array() - worse).matrix());
    }
  }
  return result;
}

/// Most of the alarm's false alarms are left to the effects that have a name: there are many more curves, and for one
/// of them to raise it, it must be rarer by this factor (a weighted test: Genovese, Roeder and Wasserman 2006).
constexpr double rarer = 16;

double smallestP(const ScoreProblem& problem, const ScoreTests& tests, const Eigen::VectorXd& ratio) {
  double result = 1;
  for (std::size_t i = 0; i < problem.groups.size(); ++i) {
    const double p = tail(ratio[at(i)], tests.freedom(i));
    result = std::min(result, i < problem.named ? p : rarer * p);
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
void describe(const ScoreProblem& problem, const std::vector<ScoreTests>& tests, const PoseScores& measured,
              const Eigen::VectorXd& priorScore, const Null& null, Evidence& evidence) {
  std::vector<double> bestDeviance(problem.groups.size(), std::numeric_limits<double>::infinity());
  for (std::size_t level = 0; level <= null.level.front(); ++level) {
    const double worse = tests[level].modelAlone(measured, priorScore).deviance[0] - null.deviance[0];
    const std::vector<ScoreTests::GroupScore> scores = tests[level].groups(measured, priorScore);
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
std::size_t bestLevel(const ScoreProblem& problem, const std::vector<ScoreTests>& tests, const Evidence& evidence) {
  double level = evidence.level, most = 0;
  for (std::size_t i = 0; i < problem.named; ++i) {
    if (evidence.groups[i].bayes > most) {
      most = evidence.groups[i].bayes;
      level = evidence.groups[i].level;
    }
  }
  const auto found =
      std::find_if(tests.begin(), tests.end(), [&](const ScoreTests& tried) { return tried.noise().pose >= level; });
  return static_cast<std::size_t>(found - tests.begin());
}

} // namespace

const std::vector<double>& poseLevels() {
  static const std::vector<double> levels = [] {
    std::vector<double> result{0};
    for (double level = radians(0.004); level < radians(1.5); level *= 1.7) {
      result.push_back(level);
    }
    return result;
  }();
  return levels;
}

Evidence evidenceOf(const ScoreProblem& problem, const Noise& noise, const std::vector<double>& levels,
                    Eigen::Index draws, std::uint64_t seed) {
  std::vector<ScoreTests> tests;
  tests.reserve(levels.size());
  for (double level : levels) {
    Noise there = noise;
    there.pose = level;
    tests.emplace_back(problem, there);
  }
  const PoseScores measured = measuredScores(*problem.linear, noise);
  const Eigen::VectorXd priorScore = problem.unknowns.cwiseQuotient(problem.sigmas.cwiseAbs2());
  const Null null = nullOf(tests, measured, priorScore);
  const ScoreTests& there = tests[null.level.front()];
  Evidence result;
  result.level = there.noise().pose;
  result.withoutScatter =
      tests.front().modelAlone(measured, priorScore).deviance[0] - null.deviance[0] + scatterPenalty(result.level);
  result.groups.resize(problem.groups.size());
  describe(problem, tests, measured, priorScore, null, result);
  const Eigen::VectorXd ratio = ratios(tests, measured, priorScore, null, problem.groups.size());
  for (std::size_t i = 0; i < problem.groups.size(); ++i) {
    result.groups[i].likelihoodRatio = ratio[at(i)];
    result.groups[i].pValue = tail(ratio[at(i)], there.freedom(i));
  }
  result.information = tests[bestLevel(problem, tests, result)].information();
  if (draws == 0) {
    return result;
  }
  const double observed = smallestP(problem, there, ratio);

  const PoseScores noiseOnly = drawnScores(*problem.linear, there.noise(), draws, seed);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(problem.own());
  const Eigen::MatrixXd drawn = ratios(tests, noiseOnly, none, nullOf(tests, noiseOnly, none), problem.groups.size());
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
