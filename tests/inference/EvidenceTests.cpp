#include "inference/Evidence.hpp"
#include "inference/NoiseLevels.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <numeric>

namespace naocal {
namespace {

/// A linear problem with random Jacobians: eight poses of four joints, six own unknowns, twelve candidates.
class RandomProblem {
public:
  static constexpr Eigen::Index poseCount = 8, joints = 4, rows = 24, own = 6, candidates = 12;

  explicit RandomProblem(std::uint64_t seed) : random_{seed} {
    for (Eigen::Index pose = 0; pose < poseCount; ++pose) {
      PoseRows& one = rows_.emplace_back();
      one.unknowns.resize(own + candidates);
      std::iota(one.unknowns.begin(), one.unknowns.end(), std::size_t{0});
      one.joints.resize(joints);
      std::iota(one.joints.begin(), one.joints.end(), std::size_t{0});
      one.errors = one.joints;
      one.stances.assign(joints, 0);
      one.errorScales.assign(joints, 1);
      one.numbers = one.freedom = rows;
      one.byDeflections = 500 * draw(rows, joints); // [px / rad]
      one.byUnknowns = draw(rows, own + candidates);
      one.byUnknowns.rightCols(candidates) = one.byDeflections * draw(joints, candidates);
      one.residual = Eigen::VectorXd::Zero(rows);
    }
    none_.blocks.resize(poseCount);
    problem_ = {rows_, none_, Eigen::VectorXd::Zero(own), Eigen::VectorXd::Constant(own, 100), candidates};
    problem_.named = candidates;
    problem_.plausible = Eigen::VectorXd::Constant(candidates, 0.01); // [rad]
    for (Eigen::Index i = 0; i < candidates; ++i) {
      problem_.groups.push_back({.first = i, .count = 1});
    }
  }
  RandomProblem(const RandomProblem&) = delete; // problem_ points into this object
  RandomProblem& operator=(const RandomProblem&) = delete;

  const ScoreProblem& problem() const { return problem_; }
  /// Measures again: a complete model with this noise.
  void measure(const Noise& noise) {
    for (PoseRows& pose : rows_) {
      pose.residual =
          noise.pixel * draw(rows, 1) + pose.byDeflections * (jointErrorRoot(pose, noise) * draw(joints, 1));
    }
  }

private:
  Eigen::MatrixXd draw(Eigen::Index height, Eigen::Index width) {
    return Eigen::MatrixXd::NullaryExpr(height, width, [&] { return normal_(random_); });
  }

  boost::random::mt19937_64 random_;
  boost::random::normal_distribution<double> normal_;
  std::vector<PoseRows> rows_;
  DriverColumns none_;
  ScoreProblem problem_;
};

/// Kolmogorov-Smirnov distance from the uniform distribution, in units of 1 / sqrt(n): 1.63 is exceeded with 1 %.
double distanceFromUniform(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto count = static_cast<double>(values.size());
  double most = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto below = static_cast<double>(i);
    most = std::max({most, values[i] - below / count, (below + 1) / count - values[i]});
  }
  return most * std::sqrt(count);
}

} // namespace

TEST_CASE("p-values of a complete model whose scatter is estimated as zero are uniform", "[slow]") {
  // Proves that p is uniform where the pose noise, truly zero, is estimated as zero, by Kolmogorov-Smirnov at 1 %: the
  // distance is 0.5 of 1.63. Compared with all draws, it is 3.1, with mean p = 0.56. Above zero, mean p is 0.45 with
  // either (`computeEvidence`).
  const Noise truth;
  std::vector<double> atBoundary;
  constexpr std::uint64_t sets = 1500;
  for (std::uint64_t seed = 1; seed <= sets; ++seed) {
    RandomProblem drawn{seed};
    drawn.measure(truth);
    const Noise noise = estimateNoiseLevels(drawn.problem(), truth, {}, {}).noise;
    if (noise.pose == 0) {
      atBoundary.push_back(computeEvidence({drawn.problem(), noise}, 199, seed).pValue);
    }
  }
  CHECK(atBoundary.size() > sets / 2);
  CHECK(atBoundary.size() < sets);
  CHECK(distanceFromUniform(atBoundary) < 1.63);
}

TEST_CASE("a Bayes factor is the likelihood ratio averaged over the sizes that the prior allows", "[fast]") {
  const double information = 400, score = 60; // estimate 0.15 of what is plausible, three standard errors
  double average = 0;
  for (const auto& [width, odds] : plausibleWidths) {
    const auto weighted = [&, w = width](double size) {
      return std::exp(score * size - information * size * size / 2 - size * size / (2 * w * w));
    };
    average += odds / (width * std::sqrt(2 * std::numbers::pi)) *
               boost::math::quadrature::gauss_kronrod<double, 61>::integrate(weighted, -1.0, 1.0);
  }
  const double bayes =
      computeBayesFactor(Eigen::MatrixXd::Constant(1, 1, information), Eigen::VectorXd::Constant(1, score));
  CHECK(bayes == Approx(2 * std::log(average)).epsilon(1e-9));
}

TEST_CASE("many small unknowns together are likelier than two of them that explain a third", "[fast]") {
  // A tracker tells the six unknowns of a link's geometry to a hundredth of what is plausible. Each is 2.6 standard
  // errors. With the widths 1 and 4 alone, both have evidence below zero, and the two are ahead.
  const auto evidence = [](Eigen::Index unknowns) {
    constexpr double information = 1e4, score = 260;
    return computeBayesFactor(information * Eigen::MatrixXd::Identity(unknowns, unknowns),
                              Eigen::VectorXd::Constant(unknowns, score));
  };
  CHECK(evidence(6) > threshold::veryStrong);
  CHECK(evidence(6) > evidence(2) + threshold::equallyLikely);
  CHECK(evidence(2) > 0);
}

} // namespace naocal
