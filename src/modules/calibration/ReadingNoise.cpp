#include "calibration/ReadingNoise.hpp"

#include "calibration/Outliers.hpp"
#include "estimation/CandidateTerms.hpp"
#include "inference/NoiseLevels.hpp"
#include "inference/Thresholds.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/Parallel.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <utility>

namespace naocal {

namespace {

/// Adds `factor` times the sums of `further` to those of `system`.
void addSums(const PoseSystem& further, double factor, PoseSystem& system) {
  system.squares += factor * further.squares;
  system.unknownGram += factor * further.unknownGram;
  system.jointErrorCross += factor * further.jointErrorCross;
  system.jointErrorGram += factor * further.jointErrorGram;
  system.unknownGradient += factor * further.unknownGradient;
  system.jointErrorGradient += factor * further.jointErrorGradient;
}

/// Number of scalar readings per noise level, of those with a weight.
std::vector<double> countReadings(const Measurements& measurements) {
  std::vector<double> result(measurements.levels.size(), 0);
  for (const ImageObservation& picture : measurements.pictures) {
    for (const WitnessObservation& observation : picture.witnesses) {
      for (const Witness::Part& part : observation.witness->parts()) {
        result[part.level] += observation.weight > 0 ? static_cast<double>(part.count) : 0;
      }
    }
  }
  return result;
}

/// As `logNoiseOfReadings`, of these numbers of readings.
double logNoiseOf(const std::vector<double>& readings, const Measurements& measurements, const Noise& noise) {
  double result = 0;
  for (std::size_t level = 0; level < readings.size(); ++level) {
    result += 2 * readings[level] * std::log(sigmaOf(measurements, noise, level));
  }
  return result;
}

/// The restricted deviance at a fit's unknowns. The sums of each unknown level's rows are taken once; a level sigma
/// weighs them by 1 / sigma^2.
class RestrictedDeviance {
public:
  RestrictedDeviance(const Measurements& measurements, const Model& wide, const Noise& noise, Eigen::VectorXd unknowns)
      : measurements_{measurements}, sigmas_{wide.sigmas()}, unknowns_{std::move(unknowns)} {
    constexpr double nothing = 1e9; // [m] or [rad]: a sigma that tells nothing
    Noise only = noise;
    only.readings.clear();
    for (const ReadingLevel& level : measurements.levels) {
      only.readings.push_back(level.isGiven ? level.sigma : nothing);
    }
    others_ = sumsAt(wide, only);
    for (std::size_t level = 0; level < rows_.size(); ++level) {
      if (measurements.levels[level].isGiven) {
        continue;
      }
      only.readings[level] = unit;
      std::vector<PoseSystem>& sums = ofLevels_.emplace(level, sumsAt(wide, only)).first->second;
      only.readings[level] = nothing;
      for (std::size_t pose = 0; pose < others_.size(); ++pose) {
        addSums(others_[pose], -1, sums[pose]);
      }
    }
  }

  double at(const Noise& noise) const {
    Eigen::MatrixXd hessian = sigmas_.cwiseAbs2().cwiseInverse().asDiagonal();
    Eigen::VectorXd gradient = unknowns_.cwiseQuotient(sigmas_.cwiseAbs2());
    double deviance = unknowns_.dot(gradient) + poseNoisePenalty(noise.pose);
    std::vector<MarginalSystem> parts(others_.size());
    parallelFor(parts.size(), [&](std::size_t pose) {
      PoseSystem system = others_[pose];
      for (const auto& [level, sums] : ofLevels_) {
        const double ratio = unit / sigmaOf(measurements_, noise, level);
        addSums(sums[pose], ratio * ratio, system);
      }
      marginalize(system, noise, jointErrorRoot(system, noise), parts[pose]);
    });
    for (std::size_t pose = 0; pose < parts.size(); ++pose) {
      const std::vector<std::size_t>& unknowns = others_[pose].unknowns;
      hessian(unknowns, unknowns) += parts[pose].hessian;
      gradient(unknowns) += parts[pose].unknownGradient;
      deviance += 2 * parts[pose].cost + (parts[pose].inner.rows() > 0 ? logDeterminant(parts[pose].inner) : 0);
    }
    const Eigen::LLT<Eigen::MatrixXd> factor{hessian};
    deviance += logDeterminant(factor) - gradient.dot(factor.solve(gradient));
    return deviance + logNoiseOf(rows_, measurements_, noise);
  }

private:
  static constexpr double unit = 1e-3; // [m] or [rad]: sigma of the sums kept

  std::vector<PoseSystem> sumsAt(const Model& wide, const Noise& noise) const {
    const Residuals residuals{measurements_, wide, noise};
    auto linear = residuals.linearize(residuals.startState(unknowns_));
    if (!linear) {
      throw behindCameraError();
    }
    return std::move(linear->poses);
  }

  const Measurements& measurements_;
  Eigen::VectorXd sigmas_, unknowns_;
  const std::vector<double> rows_ = countReadings(measurements_); // per level
  std::vector<PoseSystem> others_; // per pose: corners, the floor, and readings whose noise is given
  std::map<std::size_t, std::vector<PoseSystem>> ofLevels_; // by unknown level, per pose: its rows over `unit`
};

/// Where a function of one variable is least between two ends. It need not be unimodal: a scan finds the valley,
/// Brent's method its lowest point, to 0.1 %.
double minimize(const std::function<double(double)>& function, double low, double high) {
  constexpr int scanned = 7, bits = 10;
  const double step = (high - low) / (scanned - 1);
  double best = low, least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < scanned; ++i) {
    const double value = function(low + i * step);
    if (value < least) {
      least = value;
      best = low + i * step;
    }
  }
  return boost::math::tools::brent_find_minima(function, std::max(low, best - step), std::min(high, best + step), bits)
      .first;
}

/// The last point from `start` on, towards `end`, at which a deviance is within one unit of its least: 1 sigma.
double findEdge(const std::function<double(double)>& deviance, double start, double end) {
  constexpr int halvings = 6;
  constexpr double unit = 1;
  const double most = deviance(start) + unit;
  double inside = start, step = std::copysign(0.05, end - start);
  double outside = end;
  while (std::abs(inside + step - start) < std::abs(end - start)) {
    if (deviance(inside + step) > most) {
      outside = inside + step;
      break;
    }
    inside += step;
    step *= 2;
  }
  if (outside == end && deviance(end) <= most) {
    return end;
  }
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (inside + outside);
    (deviance(middle) > most ? outside : inside) = middle;
  }
  return inside;
}

/// The middle of what a deviance leaves possible, within 1 sigma. Where it is flat towards small levels, its least lies
/// there by chance.
double findMiddle(const std::function<double(double)>& deviance, double low, double high) {
  const double least = minimize(deviance, low, high);
  return 0.5 * (findEdge(deviance, least, low) + findEdge(deviance, least, high));
}

} // namespace

double mostNoiseOf(const ReadingLevel& level) {
  return level.unit == ReadingLevel::Unit::radians ? threshold::mostTurnNoise
         : level.name == contactLevel              ? threshold::mostContactNoise
                                                   : threshold::mostPointNoise;
}

double logNoiseOfReadings(const Measurements& measurements, const Noise& noise) {
  return logNoiseOf(countReadings(measurements), measurements, noise);
}

Noise estimateReadingNoise(const Measurements& all, const Model& model, const Fit& fit, Noise noise,
                           const std::vector<Effect>& effects) {
  if (!all.hasUnknownNoise()) {
    return noise;
  }
  const std::vector<ReadingLevel>& levels = all.levels;
  constexpr double few = 0.1; // share of readings; if more are doubtful, the model is wrong and must keep them
  const std::optional<Measurements> kept =
      shareOfDoubtful(all, model, fit) <= few ? weighDoubtful(all, model, fit) : std::nullopt;
  const Measurements& measurements = kept ? *kept : all;
  Model wide = model;
  for (Term& candidate : testableTerms(measurements, model, effects)) {
    wide.add(std::move(candidate));
  }
  const RestrictedDeviance deviance{measurements, wide, noise, mapParameters(model, fit.minimum.state.unknowns, wide)};
  noise.readings.clear();
  for (const ReadingLevel& level : levels) {
    noise.readings.push_back(level.sigma);
  }
  Noise trial = noise;
  constexpr int rounds = 2;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t level = 0; level < levels.size(); ++level) {
      if (!levels[level].isGiven) {
        trial.readings[level] = std::exp(findMiddle(
            [&](double logSigma) {
              Noise there = trial;
              there.readings[level] = std::exp(logSigma);
              return deviance.at(there);
            },
            std::log(threshold::leastReadingNoise), std::log(mostNoiseOf(levels[level]))));
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
