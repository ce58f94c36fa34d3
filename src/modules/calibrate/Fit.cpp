#include "calibrate/Fit.hpp"

#include "calibrate/StartingPlacements.hpp"

#include <algorithm>
#include <random>

namespace naocal {

namespace {

/// Joints and cameras in turns, placements along with both, until a whole round changes nothing (the thesis's way).
std::optional<FitMinimum> alternated(Residuals& residuals, Residuals::State state) {
  const auto ofJoint = [](const Term& term) {
    return term.effect.place == Place::motor || term.effect.place == Place::joint;
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
    residuals.freeOnly(round % 2 == 0 ? joints : others);
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
  residuals.freeOnly(std::vector<bool>(residuals.model().unknownCount(), true));
  minimum->linear = *residuals.linearised(minimum->state);
  minimum->iterations = iterations;
  return minimum;
}

/// Physics drawn from its priors (never beyond two sigma), placements found anew from the pictures.
Eigen::VectorXd randomStart(const Measurements& measurements, const Model& model, std::mt19937_64& random) {
  Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.unknownCount()));
  std::uniform_real_distribution<double> uniform{-1, 1};
  for (const Term& term : model.terms()) {
    for (std::size_t i = 0; i < term.effect.unknowns.size() && !term.isPlacement; ++i) {
      unknowns[static_cast<Eigen::Index>(term.first + i)] = uniform(random) * term.effect.unknowns[i].sigma;
    }
  }
  return alignedUnknowns(measurements, model, unknowns);
}

double lossScale(const std::vector<SightingResidual>& sightings, double pixelNoise) {
  std::vector<double> distances;
  for (const SightingResidual& sighting : sightings) {
    for (Eigen::Index i = 0; i < sighting.weight.size(); ++i) {
      distances.push_back(sighting.residual.col(i).norm());
    }
  }
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  constexpr double medianOfRayleigh = 1.17741; // median distance of a good corner in units of the noise per axis
  constexpr double harmless = 0.3; // [px]: what corners of printed boards scatter by; however small the noise is here
  return std::max({1.0, *middle / (medianOfRayleigh * pixelNoise), harmless / pixelNoise});
}

} // namespace

InputError behindTheCamera() {
  return InputError{
      "the search ends where a corner that was seen lies behind the camera: these captures do not belong together; "
      "check joints' signs, cameras' names and the boards"};
}

Fit firstFit(const Measurements& measurements, const Model& model, const Noise& noise,
             const CalibrationOptions& options) {
  if (measurements.cornerCount == 0) {
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
                                                  : alignedUnknowns(measurements, model, zero);
    auto minimum = options.alternate ? alternated(residuals, residuals.start(start))
                                     : levenbergMarquardt(residuals, residuals.start(start), {.smallestFall = roughly});
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

Fit refit(const Measurements& measurements, const Model& model, const Noise& noise, const Loss& loss, Fit from,
          double smallestFall) {
  const Residuals residuals{measurements, model, noise, loss};
  Residuals::State start = residuals.start(from.minimum.state.unknowns);
  if (from.noise.encoder == noise.encoder && from.noise.pose == noise.pose && from.noise.stance == noise.stance &&
      from.noise.reapproach == noise.reapproach) {
    start.deflections = from.minimum.state.deflections;
  } else {
    // deflections are counted in units of their spread: find them anew, by one quadratic step from the same unknowns
    const Residuals quadratic{measurements, model, noise};
    if (const auto linear = quadratic.linearised(start)) {
      start = quadratic.moved(start, *linear, Eigen::VectorXd::Zero(from.minimum.state.unknowns.size()));
    }
  }
  auto minimum = levenbergMarquardt(residuals, std::move(start), {.smallestFall = smallestFall});
  if (!minimum) { // the quadratic step went astray where the old minimum was possible: start from no deflection
    minimum =
        levenbergMarquardt(residuals, residuals.start(from.minimum.state.unknowns), {.smallestFall = smallestFall});
  }
  if (!minimum) {
    throw behindTheCamera();
  }
  minimum->iterations += from.minimum.iterations;
  return {noise, loss, *std::move(minimum), from.restartsChanged};
}

Fit nearlyFitted(const Measurements& measurements, const Model& model, const Noise& noise, const Loss& loss,
                 const Eigen::VectorXd& unknowns) {
  Fit from{
      Noise{.pixel = noise.pixel, .encoder = -1, .pose = -1}, loss, {}}; // other levels: deflections are found anew
  from.minimum.state.unknowns = unknowns;
  return refit(measurements, model, noise, loss, std::move(from), nearly);
}

Fit robustFit(const Measurements& measurements, const Model& model, const Noise& noise, Fit from) {
  for (int round = 0; round < 6; ++round) {
    const Residuals here{measurements, model, from.noise, from.loss};
    const double scale = lossScale(here.sightings(from.minimum.state), noise.pixel);
    if (round > 0 && std::abs(scale - from.loss.scale) < 0.02 * scale) {
      break;
    }
    from = refit(measurements, model, noise, Loss{scale}, std::move(from), roughly);
  }
  return from;
}

} // namespace naocal
