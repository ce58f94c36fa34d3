#include "calibration/ReadingNoise.hpp"

#include "estimation/ModelBuilder.hpp"
#include "inference/NoiseLevels.hpp"
#include "math/LinearAlgebra.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace naocal {

namespace {

/// The restricted deviance at a fit's unknowns.
class RestrictedDeviance {
public:
  RestrictedDeviance(const Measurements& measurements, const Model& wide, Eigen::VectorXd unknowns)
      : measurements_{measurements}, wide_{wide}, unknowns_{std::move(unknowns)}, rows_(measurements.levels.size(), 0) {
    for (const ImageObservation& picture : measurements.pictures) {
      for (const WitnessObservation& observation : picture.witnesses) {
        for (const Witness::Part& part : observation.witness->parts()) {
          rows_[part.level] += static_cast<double>(part.count);
        }
      }
    }
  }

  double at(const Noise& noise) const {
    const Residuals residuals{measurements_, wide_, noise};
    const auto linear = residuals.linearize(residuals.startState(unknowns_));
    if (!linear) {
      return std::numeric_limits<double>::infinity();
    }
    const Eigen::LLT<Eigen::MatrixXd> factor{linear->hessian};
    double deviance = -linear->gradient.dot(factor.solve(linear->gradient)) + logDeterminant(factor) +
                      unknowns_.cwiseAbs2().dot(wide_.sigmas().cwiseAbs2().cwiseInverse()) +
                      poseNoisePenalty(noise.pose);
    for (const MarginalSystem& pose : linear->eliminated) {
      deviance += 2 * pose.cost + (pose.inner.rows() > 0 ? logDeterminant(pose.inner) : 0);
    }
    for (std::size_t level = 0; level < rows_.size(); ++level) {
      deviance += 2 * rows_[level] * std::log(sigmaOf(measurements_, noise, level));
    }
    return deviance;
  }

private:
  static double logDeterminant(const Eigen::LLT<Eigen::MatrixXd>& factor) {
    return 2 * factor.matrixLLT().diagonal().array().log().sum();
  }

  const Measurements& measurements_;
  const Model& wide_;
  Eigen::VectorXd unknowns_;
  std::vector<double> rows_; // per level
};

/// Minimum of a function of one variable between two ends, which need not be unimodal: a scan, then golden sections.
double minimize(const std::function<double(double)>& function, double low, double high) {
  constexpr int scanned = 7, sections = 9;
  const double step = (high - low) / (scanned - 1);
  double best = low, least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < scanned; ++i) {
    const double value = function(low + i * step);
    if (value < least) {
      least = value;
      best = low + i * step;
    }
  }
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  double a = std::max(low, best - step), b = std::min(high, best + step);
  double c = b - golden * (b - a), d = a + golden * (b - a);
  double atC = function(c), atD = function(d);
  for (int i = 0; i < sections; ++i) {
    if (atC < atD) {
      b = std::exchange(d, c);
      atD = atC;
      c = b - golden * (b - a);
      atC = function(c);
    } else {
      a = std::exchange(c, d);
      atC = atD;
      d = a + golden * (b - a);
      atD = function(d);
    }
  }
  return 0.5 * (a + b);
}

} // namespace

Noise estimateReadingNoise(const Measurements& measurements, const Model& model, const Fit& fit, Noise noise,
                           const std::vector<Effect>& effects) {
  const std::vector<ReadingLevel>& levels = measurements.levels;
  if (std::all_of(levels.begin(), levels.end(), [](const ReadingLevel& level) { return level.isGiven; })) {
    return noise;
  }
  Model wide = model;
  for (Term& candidate : testableTerms(measurements, model, effects)) {
    wide.add(std::move(candidate));
  }
  const RestrictedDeviance deviance{measurements, wide, mapParameters(model, fit.minimum.state.unknowns, wide)};
  noise.readings.clear();
  for (const ReadingLevel& level : levels) {
    noise.readings.push_back(level.sigma);
  }
  Noise trial = noise;
  constexpr double least = 1e-6, most = 0.03; // [m] or [rad]
  constexpr int rounds = 2;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t level = 0; level < levels.size(); ++level) {
      if (!levels[level].isGiven) {
        trial.readings[level] = std::exp(minimize(
            [&](double logSigma) {
              Noise there = trial;
              there.readings[level] = std::exp(logSigma);
              return deviance.at(there);
            },
            std::log(least), std::log(most)));
      }
    }
    const double scatter = std::exp(minimize(
        [&](double logScatter) {
          Noise there = trial;
          there.pose = std::exp(logScatter);
          return deviance.at(there);
        },
        std::log(0.1 * leastScatter), std::log(mostScatter)));
    trial.pose = scatter;
  }
  noise.readings = trial.readings;
  return noise;
}

} // namespace naocal
