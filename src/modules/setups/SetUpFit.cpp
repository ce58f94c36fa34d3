#include "setups/SetUpFit.hpp"

#include "calibration/Fit.hpp"
#include "estimation/ModelBuilder.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace naocal {

namespace {

constexpr double mostTurn = radians(15); // of a joint's zero or a mount: no calibrated robot is so far off
constexpr double accidents = 0.01;       // share of blocks that are accidents
constexpr double spoilt = 0.05;          // share of blocks that accidents may spoil
constexpr double rangePx = 500;          // of a corner, anywhere in a picture [px]

/// Measurements that share their error, and are right or wrong together.
struct Block {
  double numbers = 0;    // independent ones
  double meanSquare = 0; // per axis, in the level's unit; not finite: no prediction
};

/// The blocks of one noise level.
struct Level {
  double usual = 1; // noise per axis [px], [m] or [rad]
  double range = 1; // of what is measured, per axis
  std::vector<Block> blocks;
};

/// Whether the name of a level or an instrument, "vicon" or "<set>/vicon", is that of this id.
bool isNamed(const std::string& name, const std::string& id) {
  return name == id || name.ends_with('/' + id);
}

/// How far the readings of a tracker spread per axis: the geometric mean, so that it grows with the unit of any axis
/// [m].
double rangeOfReadings(const std::vector<CaptureSet>& sets, const std::string& tracker) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double flattest = 1e-3; // range of an axis as a share of the largest
  Eigen::Array3d low = Eigen::Array3d::Constant(inf), high = -low;
  const auto include = [&](const auto& readings) {
    for (const auto& reading : readings) {
      if (isNamed(tracker, reading.tracker)) {
        low = low.min(reading.xyz.array());
        high = high.max(reading.xyz.array());
      }
    }
  };
  for (const CaptureSet& set : sets) {
    for (const Capture& capture : set.captures) {
      include(capture.points);
      include(capture.frames);
    }
  }
  const Eigen::Array3d range = high - low;
  const double most = range.maxCoeff();
  return std::isfinite(most) && most > 0 ? std::cbrt(range.max(flattest * most).prod()) : 1;
}

/// Corners first, then the levels of readings.
std::vector<Level> listLevels(const Measurements& measurements) {
  std::vector<Level> levels{{usualPx, rangePx, {}}};
  for (const ReadingLevel& level : measurements.levels) {
    const bool isLength = level.unit == ReadingLevel::Unit::metres;
    levels.push_back({std::max(isLength ? usualMetres : usualRadians, level.isGiven ? level.sigma : 0),
                      isLength ? rangeOfReadings(*measurements.sets, level.name) : std::numbers::pi,
                      {}});
  }
  return levels;
}

void addCorners(const std::vector<BoardResidual>& observations, Level& level) {
  constexpr double most = 6; // degrees of freedom of a board before a camera
  for (const BoardResidual& observation : observations) {
    const auto numbers = static_cast<double>(observation.residual.size());
    level.blocks.push_back({std::min(most, numbers), observation.residual.squaredNorm() / numbers});
  }
}

void addReadings(const Measurements& measurements, const std::vector<WitnessResidual>& residuals,
                 std::vector<Level>& levels) {
  for (const WitnessResidual& one : residuals) {
    const Witness& witness = *measurements.pictures[one.picture].witnesses[one.witness].witness;
    for (const Witness::Part& part : witness.parts()) {
      const auto numbers = static_cast<double>(part.count);
      if (witness.target().empty()) { // a distance between places is no error of the robot
        continue;
      }
      levels[1 + part.level].blocks.push_back(
          {numbers, one.residual.segment(part.first, part.count).squaredNorm() / numbers});
    }
  }
}

/// -2 ln of the mixture of noise and accidents, for all blocks of a level, with the range as the unit.
double lengthAt(double sigma, const Level& level) {
  const double relative = sigma / level.range;
  double length = 0;
  for (const Block& block : level.blocks) {
    const double accident = 2 * std::log(1 / accidents);
    const double noise = std::isfinite(block.meanSquare)
                             ? block.numbers * (std::log(2 * std::numbers::pi * relative * relative) +
                                                block.meanSquare / (sigma * sigma)) -
                                   2 * std::log(1 - accidents)
                             : std::numeric_limits<double>::infinity();
    const double least = std::min(accident, noise);
    length += least - 2 * std::log1p(std::exp(-0.5 * std::abs(accident - noise)));
  }
  return length;
}

double lengthOf(const Level& level) {
  constexpr int steps = 40;
  const double low = 0.5 * level.usual, high = std::max(level.range, 2 * low);
  double least = std::numeric_limits<double>::infinity();
  for (int step = 0; step <= steps; ++step) {
    least = std::min(least, lengthAt(low * std::pow(high / low, static_cast<double>(step) / steps), level));
  }
  return least;
}

/// rms error over all blocks of all levels, in usual noises, without the worst share of them.
double errorOf(const std::vector<Level>& levels, double worst) {
  std::vector<Block> blocks;
  for (const Level& level : levels) {
    for (const Block& block : level.blocks) {
      blocks.push_back({block.numbers, block.meanSquare / (level.usual * level.usual)});
    }
  }
  std::sort(blocks.begin(), blocks.end(), [](const Block& a, const Block& b) { return a.meanSquare < b.meanSquare; });
  blocks.resize(blocks.size() - static_cast<std::size_t>(worst * static_cast<double>(blocks.size())));
  double numbers = 0, squares = 0;
  for (const Block& block : blocks) {
    numbers += block.numbers;
    squares += block.numbers * block.meanSquare;
  }
  return std::isfinite(squares) && numbers > 0 ? std::sqrt(squares / numbers) : std::numeric_limits<double>::infinity();
}

/// rms of the corners, else of the readings in metres, as a length.
std::string formatError(const Measurements& measurements, const std::vector<Level>& levels) {
  const auto rms = [&](std::size_t level, double axes) {
    return std::sqrt(axes) * levels[level].usual * errorOf({levels[level]}, 0);
  };
  if (!levels.front().blocks.empty()) {
    return fmt::format("{:.1f} px", rms(0, 2));
  }
  for (std::size_t i = 1; i < levels.size(); ++i) {
    if (!levels[i].blocks.empty() && measurements.levels[i - 1].unit == ReadingLevel::Unit::metres) {
      return fmt::format("{:.3g} mm", 1e3 * rms(i, 3));
    }
  }
  return {};
}

/// Square sum of the unknowns in prior sigmas; finds the largest turn of a joint's zero or a camera's mount.
double weighUnknowns(const Model& model, SetUpFit& fit) {
  for (const Term& term : model.terms()) {
    const bool isMount = term.effect.name == effectName::cameraRotation;
    if (!isMount && (term.effect.name != effectName::jointOffset || term.effect.unknowns.front().unit != "rad")) {
      continue;
    }
    for (const double value : term.values(fit.unknowns)) {
      if (std::abs(value) > std::max(mostTurn, std::abs(fit.farTurn))) {
        fit.farPlace = (isMount ? "the mount of camera " : "") + term.placeName;
        fit.isMountFar = isMount;
        fit.farTurn = value;
      }
    }
  }
  return fit.unknowns.cwiseQuotient(model.sigmas()).squaredNorm();
}

/// Readings of joints beyond their limits, which the joints cannot have taken: accidents, or another unit or joint.
double weighLimits(const Measurements& measurements) {
  constexpr double farthest = 4 * std::numbers::pi; // of a joint without limits [rad]
  double beyond = 0;
  for (const std::size_t index : measurements.joints) {
    const Joint& joint = measurements.robot.joints[index];
    if (joint.isPrismatic) {
      continue;
    }
    const double low = std::max(joint.limits.lower - mostTurn, -farthest),
                 high = std::min(joint.limits.upper + mostTurn, farthest);
    for (const ImageObservation& picture : measurements.pictures) {
      const double angle = picture.instant.q[static_cast<Eigen::Index>(index)];
      beyond += angle < low || angle > high ? 1 : 0;
    }
  }
  return 2 * beyond * std::log(1 / accidents);
}

} // namespace

AskedModel AskedModel::of(const Measurements& measurements, const Model& model) {
  AskedModel asked;
  const Model base = buildModel(measurements);
  for (const Term& term : model.terms()) {
    if (term.requested && !term.isPlacement && !base.find(term.label())) {
      asked.with.push_back(term.label());
    }
    const auto isSame = [&](const Effect& effect) { return effect.name == term.effect.name; };
    if (!term.effect.definition.empty() && std::none_of(asked.effects.begin(), asked.effects.end(), isSame)) {
      asked.effects.push_back(term.effect);
    }
  }
  for (const Term& term : base.terms()) {
    if (!term.isPlacement && !model.find(term.label())) {
      asked.without.push_back(term.label());
    }
  }
  return asked;
}

Model AskedModel::build(const Measurements& measurements) const {
  return buildModel(measurements, with, without, effects);
}

namespace {

/// The blocks of a fit, by level.
std::vector<Level> collectLevels(const Measurements& measurements, const Model& model,
                                 const Eigen::VectorXd& unknowns) {
  const Residuals residuals{measurements, model, Noise{.encoder = 0}};
  const auto state = residuals.startState(unknowns);
  std::vector<Level> levels = listLevels(measurements);
  addCorners(residuals.boardResiduals(state), levels.front());
  addReadings(measurements, residuals.witnessResiduals(state), levels);
  return levels;
}

/// Noise at which the errors of a fit are usual, at least that of usual instruments: a kind of measurement that nothing
/// explains yet must not bend what explains the others.
Noise noiseOf(const std::vector<Level>& levels) {
  const auto sigma = [](const Level& level) {
    const double error = level.blocks.empty() ? 1 : errorOf({level}, spoilt);
    return level.usual * std::clamp(error, 1.0, level.range / level.usual);
  };
  Noise noise{.pixel = sigma(levels.front()), .encoder = 0};
  for (std::size_t i = 1; i < levels.size(); ++i) {
    noise.readings.push_back(sigma(levels[i]));
  }
  return noise;
}

/// Much more noise than usual: a first search whose priors still count beside a gross misfit.
Noise firstNoise(const Measurements& measurements) {
  constexpr double generous = 30;
  Noise noise{.pixel = generous * usualPx, .encoder = 0};
  for (const ReadingLevel& level : measurements.levels) {
    noise.readings.push_back(generous * (level.unit == ReadingLevel::Unit::metres ? usualMetres : usualRadians));
  }
  return noise;
}

} // namespace

SetUpFit assessFit(const Measurements& measurements, const Model& model, const Eigen::VectorXd& unknowns) {
  const std::vector<Level> levels = collectLevels(measurements, model, unknowns);
  SetUpFit fit;
  fit.unknowns = unknowns;
  fit.length = weighUnknowns(model, fit) + weighLimits(measurements);
  for (const Level& level : levels) {
    fit.length += level.blocks.empty() ? 0 : lengthOf(level);
    for (const Block& block : level.blocks) {
      fit.numbers += block.numbers;
    }
  }
  fit.error = errorOf(levels, 0);
  fit.typicalError = errorOf(levels, spoilt);
  fit.size = formatError(measurements, levels);
  return fit;
}

std::optional<SetUpFit> fitAnew(const Measurements& measurements, const Model& model, const FitEffort& effort) {
  try {
    CalibrationOptions options;
    options.maxIterations = effort.iterations;
    // what joints scatter is nothing beside a wrong set-up, and takes most of the time
    Fit fit = fitInitially(measurements, model, firstNoise(measurements), options);
    options.start = fit.minimum.state.unknowns;
    const Noise noise = noiseOf(collectLevels(measurements, model, *options.start));
    fit = fitInitially(measurements, model, noise, options);
    SetUpFit best = assessFit(measurements, model, fit.minimum.state.unknowns);
    if (effort.robust) {
      const Fit robust = fitRobustly(measurements, model, noise, fit);
      SetUpFit other = assessFit(measurements, model, robust.minimum.state.unknowns);
      if (other.length < best.length) {
        best = std::move(other);
      }
    }
    return std::isfinite(best.length) ? std::optional{best} : std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

} // namespace naocal
