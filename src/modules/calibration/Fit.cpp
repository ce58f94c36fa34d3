#include "calibration/Fit.hpp"

#include "calibration/Initialization.hpp"
#include "calibration/ReadingErrors.hpp"
#include "inference/NoiseLevels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <random>

namespace naocal {

namespace {

/// Alternates joints and cameras, each with the placements, until a full round changes nothing (the method of
/// Adikari's thesis, docs/evaluation.md).
std::optional<FitMinimum> alternate(Residuals& residuals, Residuals::State state) {
  const auto ofJoint = [](const Term& term) {
    return term.effect.placeKind == PlaceKind::motor || term.effect.placeKind == PlaceKind::joint;
  };
  std::vector<bool> joints(residuals.model().unknownCount(), true), others = joints;
  for (const Term& term : residuals.model().terms()) {
    for (std::size_t i = term.first; i < term.first + term.effect.unknowns.size(); ++i) {
      joints[i] = term.isPlacement || ofJoint(term);
      others[i] = term.isPlacement || !ofJoint(term);
    }
  }
  std::optional<FitMinimum> minimum;
  int iterations = 0;
  double before = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 200; ++round) {
    residuals.setFree(round % 2 == 0 ? joints : others);
    minimum = levenbergMarquardt(residuals, std::move(state));
    if (!minimum) {
      return std::nullopt;
    }
    state = minimum->state;
    iterations += minimum->iterations;
    minimum->converged = before - minimum->linear.cost < 1e-6;
    if (round % 2 == 1) {
      if (minimum->converged) {
        break;
      }
      before = minimum->linear.cost;
    }
  }
  residuals.setFree(std::vector<bool>(residuals.model().unknownCount(), true));
  minimum->linear = *residuals.linearize(minimum->state);
  minimum->iterations = iterations;
  return minimum;
}

/// Random start: physical unknowns uniform within one prior sigma, placements initialised from the pictures.
Eigen::VectorXd randomStart(const Measurements& measurements, const Model& model, std::mt19937_64& random) {
  Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.unknownCount()));
  std::uniform_real_distribution<double> uniform{-1, 1};
  for (const Term& term : model.terms()) {
    for (std::size_t i = 0; i < term.effect.unknowns.size() && !term.isPlacement; ++i) {
      unknowns[static_cast<Eigen::Index>(term.first + i)] = uniform(random) * term.effect.unknowns[i].sigma;
    }
  }
  return alignBoards(measurements, model, unknowns);
}

/// Share of good corners within `distance` noise levels of their prediction (Rayleigh distribution).
struct Quantile {
  double share, distance;
};
constexpr Quantile medianCorner{0.5, 1.17741}, farCorner{0.9, 2.14597};

/// Noise per axis [px] at which `quantile.share` of all distances lies within the observed quantile; 0 without any.
double spreadOf(std::vector<double> distances, const Quantile& quantile) {
  if (distances.empty()) {
    return 0;
  }
  const auto there =
      distances.begin() + static_cast<std::ptrdiff_t>(quantile.share * static_cast<double>(distances.size()));
  std::nth_element(distances.begin(), there, distances.end());
  return *there / quantile.distance;
}

double spreadOf(const std::vector<BoardResidual>& observations, const Quantile& quantile) {
  std::vector<double> distances;
  for (const BoardResidual& observation : observations) {
    for (Eigen::Index i = 0; i < observation.weight.size(); ++i) {
      const double distance = observation.residual.col(i).norm();
      distances.push_back(std::isfinite(distance) ? distance : std::numeric_limits<double>::infinity());
    }
  }
  return spreadOf(std::move(distances), quantile);
}

/// Scale of the loss: so wide that a missing effect turns no kind of measurement into outliers.
double lossScale(const Residuals& residuals, const Residuals::State& state, double pixelNoise) {
  constexpr double harmless = 0.3; // [px]: scatter of corners of printed boards; lower bound of the loss scale
  const Measurements& measurements = residuals.measurements();
  const double readings =
      spreadOf(scaledDistances(measurements, residuals.witnessResiduals(state), residuals.noise()), medianCorner);
  return std::max({1.0, spreadOf(residuals.boardResiduals(state), medianCorner) / pixelNoise, readings / pixelNoise,
                   measurements.cornerCount > 0 ? harmless / pixelNoise : 0.0});
}

/// Misfit variance per axis [px^2] beyond the noise floor, joint angles as read, from the 90 % quantile of the
/// distances. 0 if the distances are below 1.2 times the noise floor. Absent if a corner lies behind its camera.
std::optional<double> assessMisfit(const Residuals& residuals, const Residuals::State& state) {
  constexpr double sound = 1.2;
  const double spread = spreadOf(residuals.boardResiduals(residuals.startState(state.unknowns)), farCorner);
  if (!std::isfinite(spread)) {
    return std::nullopt;
  }
  const double floor = noiseFloorPx(residuals.rows(state).value(), residuals.noise()) / std::numbers::sqrt2;
  return spread < sound * floor ? 0 : spread * spread - floor * floor;
}

/// The same unknowns under other noise and loss, with deflections re-optimised. Absent if a corner comes to lie behind
/// its camera.
std::optional<Fit> restart(const Measurements& measurements, const Model& model, const Noise& noise, const Loss& loss,
                           const Fit& from) {
  Residuals residuals{measurements, model, noise, loss};
  residuals.setFree(std::vector<bool>(model.unknownCount(), false));
  auto minimum = levenbergMarquardt(residuals, residuals.startState(from.minimum.state.unknowns));
  if (!minimum) {
    return std::nullopt;
  }
  residuals.setFree(std::vector<bool>(model.unknownCount(), true));
  auto linear = residuals.linearize(minimum->state);
  if (!linear) {
    return std::nullopt;
  }
  minimum->linear = *std::move(linear);
  minimum->iterations = from.minimum.iterations;
  minimum->converged = from.minimum.converged;
  return Fit{noise, loss, *std::move(minimum), from.restartsChanged};
}

} // namespace

InputError behindCameraError() {
  return InputError{
      "the search ends where a corner that was seen lies behind the camera: these captures do not belong together; "
      "check joints' signs, cameras' names and the boards"};
}

Fit fitInitially(const Measurements& measurements, const Model& model, const Noise& noise,
                 const CalibrationOptions& options) {
  if (measurements.cornerCount + measurements.witnessCount == 0) {
    throw InputError{
        "these captures show no corner that a camera could learn from: run 'naocal detect', or check which "
        "boards, links and support feet the file names"};
  }
  const bool goesOn = options.start && options.loss && options.robust && options.restarts == 0;
  Fit fit{noise, goesOn ? *options.loss : Loss{}, {}};
  Residuals residuals{measurements, model, noise, fit.loss};
  std::optional<FitMinimum> best;
  std::mt19937_64 random{options.seed};
  for (int attempt = 0; attempt <= options.restarts; ++attempt) {
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.unknownCount()));
    const Eigen::VectorXd start = attempt > 0     ? randomStart(measurements, model, random)
                                  : options.start ? *options.start
                                                  : alignBoards(measurements, model, zero);
    auto minimum =
        options.alternate
            ? alternate(residuals, residuals.startState(start))
            : levenbergMarquardt(residuals, residuals.startState(start),
                                 {.maxIterations = options.maxIterations, .minCostDecrease = coarseTolerance});
    if (minimum && (!best || minimum->linear.cost < best->linear.cost - 1e-3)) {
      fit.restartsChanged |= attempt > 0;
      best = std::move(minimum);
    }
  }
  if (!best) {
    throw InputError{
        "the search cannot start: with the drawing's geometry a corner that was seen lies behind the camera; "
        "check the robot's model, the cameras' names and the boards' placements in the file"};
  }
  fit.minimum = *std::move(best);
  return fit;
}

double rmsAsReported(const Measurements& measurements, const Model& model, const Fit& fit) {
  const Residuals residuals{measurements, model, fit.noise, fit.loss};
  const auto asRead = residuals.startState(fit.minimum.state.unknowns);
  return summarizeDistances(collectDistances(measurements, residuals.boardResiduals(asRead),
                                             residuals.witnessResiduals(asRead), fit.noise))
      .rmsPx;
}

Fit refit(const Measurements& measurements, const Model& model, const Noise& noise, const Loss& loss, Fit from,
          double smallestFall) {
  const Residuals residuals{measurements, model, noise, loss};
  Residuals::State start = residuals.startState(from.minimum.state.unknowns);
  if (from.noise.encoder == noise.encoder && from.noise.pose == noise.pose && from.noise.stance == noise.stance &&
      from.noise.reapproach == noise.reapproach && from.noise.readings == noise.readings) {
    start.deflections = from.minimum.state.deflections;
  } else {
    // Deflections are in units of their sigma, or fit readings too loosely for their noise, so that a robust loss would
    // take these for outliers: one quadratic step at the same unknowns.
    const Residuals quadratic{measurements, model, noise};
    if (const auto linear = quadratic.linearize(start)) {
      start = quadratic.applyStep(start, *linear, Eigen::VectorXd::Zero(from.minimum.state.unknowns.size()));
    }
  }
  auto minimum = levenbergMarquardt(residuals, std::move(start), {.minCostDecrease = smallestFall});
  if (!minimum) { // the quadratic step made the start infeasible: restart from zero deflections
    minimum = levenbergMarquardt(residuals, residuals.startState(from.minimum.state.unknowns),
                                 {.minCostDecrease = smallestFall});
  }
  if (!minimum) {
    throw behindCameraError();
  }
  minimum->iterations += from.minimum.iterations;
  return {noise, loss, *std::move(minimum), from.restartsChanged};
}

Fit fitForComparison(const Measurements& measurements, const Model& model, const Noise& noise, const Loss& loss,
                     const Eigen::VectorXd& unknowns) {
  Fit from{
      Noise{.pixel = noise.pixel, .encoder = -1, .pose = -1}, loss, {}}; // differs from `noise`: forces new deflections
  from.minimum.state.unknowns = unknowns;
  return refit(measurements, model, noise, loss, std::move(from), comparisonTolerance);
}

Fit fitRobustly(const Measurements& measurements, const Model& model, const Noise& noise, Fit from) {
  for (int round = 0; round < 6; ++round) {
    const Residuals here{measurements, model, from.noise, from.loss};
    const double scale = lossScale(here, from.minimum.state, noise.pixel);
    if (round > 0 && std::abs(scale - from.loss.scale) < 0.02 * scale) {
      break;
    }
    from = refit(measurements, model, noise, Loss{scale}, std::move(from), coarseTolerance);
  }
  return from;
}

bool isMostlyOutliers(const BoardResidual& observation) {
  return observation.weight.size() > 1 &&
         2 * (observation.weight.array() < outlierWeight).count() > observation.weight.size();
}

Fit refitWithMisfitNoise(const Measurements& measurements, const Model& model, const Fit& from) {
  constexpr int rounds = 2;
  constexpr double nearer = 0.9; // ratio of rms errors; above it the original weights stay
  Fit fit = from;
  for (int round = 0; round < rounds; ++round) {
    const std::optional<double> misfit = assessMisfit({measurements, model, fit.noise, fit.loss}, fit.minimum.state);
    if (!misfit || *misfit == 0) {
      break;
    }
    Noise wide = fit.noise;
    wide.pixel = std::hypot(fit.noise.pixel, std::sqrt(*misfit));
    const Loss same{fit.loss.scale * fit.noise.pixel / wide.pixel}; // keeps the loss scale constant in pixels
    auto there = restart(measurements, model, fit.noise, fit.loss, refit(measurements, model, wide, same, fit));
    if (!there) {
      break;
    }
    fit = *std::move(there);
  }
  const double before = rmsAsReported(measurements, model, from);
  double least = rmsAsReported(measurements, model, fit);
  if (from.noise.pose > 0 || from.noise.reapproach > 0 || from.noise.stance > 0) { // deflections may hide the misfit
    Noise rigid = from.noise;
    rigid.pose = rigid.reapproach = rigid.stance = 0;
    auto there =
        restart(measurements, model, from.noise, from.loss, refit(measurements, model, rigid, from.loss, from));
    if (const double rms = there ? rmsAsReported(measurements, model, *there) : least; rms < nearer * least) {
      fit = *std::move(there);
      least = rms;
    }
  }
  return least < nearer * before || !std::isfinite(before) ? fit : from;
}

} // namespace naocal
