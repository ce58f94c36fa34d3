#include "inference/NoiseLevels.hpp"

#include "inference/ModelWindow.hpp"
#include "inference/ScoreTest.hpp"
#include "math/Angles.hpp"
#include "math/Parallel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace naocal {

double noiseFloorPx(const std::vector<PoseRows>& poses, const Noise& noise) {
  const double corner = noise.pixel * noise.pixel + noise.pixelAlike * noise.pixelAlike;
  double numbers = 0, expected = 0;
  for (const PoseRows& pose : poses) {
    numbers += pose.numbers;
    const Eigen::MatrixXd moved = pose.byDeflections * jointErrorRoot(pose, noise);
    expected += corner * pose.numbers + moved.squaredNorm();
  }
  return std::sqrt(2 * expected / std::max(1.0, numbers));
}

namespace {

constexpr double usualScatter = radians(0.02);
constexpr double unbound = 0.05; // [rad]: pose noise that leaves every joint practically unconstrained

/// Score and information of the candidate effects, in units of `plausible`.
struct Candidates {
  Eigen::VectorXd score;
  Eigen::MatrixXd information;
};

/// -2 ln likelihood of candidates ~ N(0, kappa^2), relative to no candidates.
double computeDeviance(const Candidates& all, double kappa) {
  Eigen::MatrixXd posterior = all.information;
  posterior.diagonal().array() += 1 / (kappa * kappa);
  const Eigen::LLT<Eigen::MatrixXd> factor{posterior};
  return 2 * factor.matrixLLT().diagonal().array().log().sum() +
         2 * static_cast<double>(all.score.size()) * std::log(kappa) - all.score.dot(factor.solve(all.score));
}

/// D(level) of the widest model (`estimateNoiseLevels`).
double wideDeviance(const ScoreProblem& problem, const Noise& noise, bool sparse = false) {
  constexpr std::array kappas{0.1, 0.2, 0.4, 0.7, 1.0, 1.5, 2.5};
  const MeasuredTests measured{problem, noise};
  const ColumnGroup last = problem.named > 0 ? problem.groups[problem.named - 1] : ColumnGroup{};
  const Eigen::Index count = last.first + last.count; // without curves, which would fit scatter
  const Eigen::VectorXd plausible = problem.plausible.head(count);
  const Candidates all{plausible.cwiseProduct(measured.scores.head(count)),
                       plausible.asDiagonal() * measured.tests.information().topLeftCorner(count, count) *
                           plausible.asDiagonal()};
  double least = 0;
  for (const double kappa : kappas) {
    least = std::min(least, computeDeviance(all, kappa));
  }
  if (sparse) {
    const ExplanationCosts costs = costExplanations(measured);
    least = std::min(costs.fitted + least, costs.likeliest);
  }
  return measured.outcome.deviance[0] + least;
}

/// Deviance over one noise level, the other levels fixed as in `noise`.
struct LevelCurve {
  std::vector<double> levels, deviances;

  LevelCurve(const ScoreProblem& problem, const Noise& noise, double Noise::*level, bool penalised, bool sparse = false)
      : sparse_{sparse} {
    add(problem, noise, level, penalised,
        {0, radians(0.01), radians(0.02), radians(0.03), radians(0.045), radians(0.065), radians(0.09), radians(0.12),
         mostScatter});
    const std::size_t best = lowest(); // refines the grid around the minimum
    const double before = levels[best > 0 ? best - 1 : 0], here = levels[best],
                 after = levels[std::min(best + 1, levels.size() - 1)];
    std::vector<double> closer;
    for (const double part : {0.35, 0.7}) {
      closer.push_back(std::lerp(before, here, part));
      closer.push_back(std::lerp(after, here, part));
    }
    std::erase(closer, here);
    add(problem, noise, level, penalised, closer);
  }

  std::size_t lowest() const {
    return static_cast<std::size_t>(std::min_element(deviances.begin(), deviances.end()) - deviances.begin());
  }
  /// Minimum of the parabola through the lowest level and its neighbours.
  double peak() const {
    const std::size_t best = lowest();
    if (best == 0 || best + 1 == levels.size()) {
      return levels[best];
    }
    const double left = levels[best] - levels[best - 1], right = levels[best + 1] - levels[best];
    const double fall = (deviances[best - 1] - deviances[best]) / left,
                 rise = (deviances[best + 1] - deviances[best]) / right;
    if (!(fall + rise > 0)) {
      return levels[best]; // flat
    }
    return std::clamp(levels[best] + 0.5 * (fall * right - rise * left) / (fall + rise), levels[best - 1],
                      levels[best + 1]);
  }
  /// Posterior probability of each level: likelihood times the width of its grid cell.
  std::vector<double> weights() const {
    const double least = deviances[lowest()];
    std::vector<double> result;
    double sum = 0;
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const double width = levels[std::min(i + 1, levels.size() - 1)] - levels[i > 0 ? i - 1 : 0];
      result.push_back(width * std::exp((least - deviances[i]) / 2));
      sum += result.back();
    }
    for (double& weight : result) {
      weight /= sum;
    }
    return result;
  }

private:
  void add(const ScoreProblem& problem, const Noise& noise, double Noise::*level, bool penalised,
           const std::vector<double>& further) {
    std::vector<double> found(further.size());
    parallelFor(further.size(), [&](std::size_t i) {
      Noise there = noise;
      there.*level = further[i];
      found[i] = wideDeviance(problem, there, sparse_) + (penalised ? poseNoisePenalty(further[i]) : 0);
    });
    for (std::size_t i = 0; i < further.size(); ++i) {
      const auto place = std::upper_bound(levels.begin(), levels.end(), further[i]) - levels.begin();
      levels.insert(levels.begin() + place, further[i]);
      deviances.insert(deviances.begin() + place, found[i]);
    }
  }

  bool sparse_; // whether few effects stand beside the random ones
};

} // namespace

double poseNoisePenalty(double level) {
  const double ratio = level / usualScatter;
  return 2 * std::log1p(ratio * ratio);
}

NoiseLevels estimateNoiseLevels(const ScoreProblem& wide, const Noise& noise, const RepeatInfo& repeated,
                                const std::vector<bool>& varies) {
  const EffectsOnly effects{wide};
  const ScoreProblem& problem = effects.problem();
  NoiseLevels result{noise, {}};
  result.noise.reapproach = result.noise.stance = 0;
  Noise within = result.noise; // uses only differences within poses
  within.pose = unbound;
  if (repeated.reapproached) {
    within.stance = repeated.restood ? unbound : 0; // with new stances: only differences within a stance
    const EffectsOnly varying{wide, varies};
    within.reapproach = LevelCurve{varying.problem(), within, &Noise::reapproach, false}.peak();
  }
  if (repeated.restood) {
    within.stance = LevelCurve{problem, within, &Noise::stance, true}.peak();
  }
  result.noise.reapproach = within.reapproach;
  result.noise.stance = within.stance;
  const LevelCurve curve{problem, result.noise, &Noise::pose, true, repeated.none};
  result.noise.pose = curve.peak();
  const std::vector<double> weights = curve.weights();
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] > 1e-6) {
      result.levels.push_back({result.noise, weights[i]});
      result.levels.back().noise.pose = curve.levels[i];
    }
  }
  result.scatter = curve.deviances.front() - curve.deviances[curve.lowest()];
  return result;
}

bool isPoseNoiseAtBoundary(const ScoreProblem& wide, const Noise& noise) {
  const EffectsOnly effects{wide};
  Noise none = noise, least = noise;
  none.pose = 0;
  least.pose = leastScatter;
  return wideDeviance(effects.problem(), none) <=
         wideDeviance(effects.problem(), least) + poseNoisePenalty(leastScatter);
}

} // namespace naocal
