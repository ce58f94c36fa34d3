#include "calibration/Calibration.hpp"

#include "calibration/BoardMoves.hpp"
#include "calibration/Fit.hpp"
#include "calibration/ModelUncertainty.hpp"
#include "calibration/NoiseEstimation.hpp"
#include "calibration/Outliers.hpp"
#include "calibration/ReadingNoise.hpp"
#include "calibration/Uncertainty.hpp"
#include "calibration/result/Verdict.hpp"

#include <algorithm>
#include <chrono>
#include <functional>

namespace naocal {

namespace {

/// What tells the noise of the measurements, apart from what joints do.
enum class NoiseSource {
  configured,     // the options
  withinPictures, // errors within pictures, while joints scatter by an amount that nobody knows
  repeats         // repeated captures; or there are no pixels
};

/// A fit with consistent noise levels, and the analysis of missing effects.
struct NoiseConsistentFit {
  Fit fit;
  NoiseLevels levels;
  NoiseSource source = NoiseSource::configured;
  std::optional<MissingEffectAnalysis> explained;
};

/// Sets the noise of readings that the sets do not give, and the pixel noise: from repeats, else from the residuals
/// within pictures, unless the user gave it.
NoiseSource estimateMeasurementNoise(const Measurements& measurements, const Model& model, const Fit& fit,
                                     const CalibrationOptions& options, Noise& noise) {
  if (measurements.witnessCount > 0) {
    noise = estimateReadingNoise(measurements, model, fit, std::move(noise), options.effects);
  }
  if (measurements.cornerCount == 0) {
    return NoiseSource::repeats; // there are no pixels to tell from scatter
  }
  const Residuals residuals{measurements, model, fit.noise, fit.loss};
  const std::vector<BoardResidual> observations = residuals.boardResiduals(fit.minimum.state);
  if (const auto repeats = estimatePixelNoiseFromRepeats(measurements, observations)) {
    noise.pixel = repeats->anew;
    noise.pixelAlike = repeats->alike;
    return NoiseSource::repeats;
  }
  const auto within = options.pixelGiven ? std::nullopt : estimatePixelNoiseWithinImages(observations);
  noise.pixel = within.value_or(noise.pixel);
  return within ? NoiseSource::withinPictures : NoiseSource::configured;
}

/// Which kinds of repeats the captures contain.
RepeatInfo countRepeatedRests(const Measurements& measurements, NoiseSource source) {
  const auto some = [&](bool PoseGroup::*kind) {
    return std::any_of(measurements.poses.begin(), measurements.poses.end(), std::mem_fn(kind));
  };
  return {.reapproached = some(&PoseGroup::repeated),
          .restood = some(&PoseGroup::restood),
          .none = source == NoiseSource::withinPictures};
}

/// Continues from a fit at new noise levels, with or without robust loss; stops at `coarseTolerance`.
Fit fitFurther(const Measurements& measurements, const Model& model, const CalibrationOptions& options,
               const Noise& noise, Fit from) {
  return options.robust ? fitRobustly(measurements, model, noise, std::move(from))
                        : refit(measurements, model, noise, Loss{}, std::move(from), coarseTolerance);
}

/// Refines a fit: pixel noise, joint noise levels under the widest model, and missing effects at those levels.
NoiseConsistentFit fitWithNoise(const Measurements& measurements, const Model& model, const CalibrationOptions& options,
                                Fit fit) {
  NoiseConsistentFit answer{fitFurther(measurements, model, options, options.noise, std::move(fit)),
                            {options.noise},
                            NoiseSource::configured,
                            {}};
  if (options.estimateNoise) {
    for (int round = 0; round < 2; ++round) {
      answer.source = estimateMeasurementNoise(measurements, model, answer.fit, options, answer.levels.noise);
      answer.fit = fitFurther(measurements, model, options, answer.levels.noise, std::move(answer.fit));
    }
  }
  std::optional<RepeatInfo> repeats;
  if (answer.source == NoiseSource::repeats ||
      (answer.source == NoiseSource::withinPictures && options.scatterWithoutRepeats)) {
    repeats = countRepeatedRests(measurements, answer.source);
  }
  if (options.testMissingEffects) {
    answer.explained = analyseMissingEffects(measurements, model, answer.fit, answer.levels.noise, repeats, options);
    answer.levels = answer.explained->levels;
    answer.fit = answer.explained->fit;
  } else {
    const Loss loss = answer.fit.loss;
    answer.fit = refit(measurements, model, answer.levels.noise, loss, std::move(answer.fit)); // converges fully
  }
  return answer;
}

/// Excludes, one at a time, observations whose board was displaced beyond doubt under any explanation. Returns the
/// remaining measurements, or nothing if none was excluded.
std::optional<Measurements> excludeMovedBoards(const Measurements& measurements, const Model& model,
                                               const CalibrationOptions& options, NoiseConsistentFit& answer) {
  const std::size_t most = DisplacedBoardCount{measurements, {}}.mostSetAside();
  std::optional<Measurements> kept;
  for (std::size_t aside = 0; aside < most; ++aside) {
    const Measurements& used = kept ? *kept : measurements;
    const auto moved = answer.explained
                           ? findDisplacedBoard(used, answer.explained->larger, answer.explained->largerFit,
                                                answer.explained->window.misfit)
                           : findDisplacedBoard(used, model, answer.fit);
    if (!moved) {
      break;
    }
    if (!kept) {
      kept = measurements;
    }
    excludeObservation(*kept, *moved);
    answer = fitWithNoise(*kept, model, options, std::move(answer.fit));
  }
  return kept;
}

/// The model with priors widened where the fit requires it (`widenPriors` in calibration/ModelUncertainty.hpp).
std::optional<Model> widenPriors(const Model& model, const Fit& fit) {
  const Eigen::MatrixXd& hessian = fit.minimum.linear.hessian;
  const Eigen::MatrixXd covariance = hessian.ldlt().solve(Eigen::MatrixXd::Identity(hessian.rows(), hessian.cols()));
  return widenPriors(model, fit.minimum.state.unknowns, covariance.diagonal());
}

} // namespace

CalibrationResult calibrate(const Measurements& measurements, const Model& model, const CalibrationOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  NoiseConsistentFit answer =
      fitWithNoise(measurements, model, options, fitInitially(measurements, model, options.noise, options));
  const auto kept = options.robust && options.excludeDisplaced
                        ? excludeMovedBoards(measurements, model, options, answer)
                        : std::nullopt;
  const Measurements& used = kept ? *kept : measurements;
  const std::optional<Model> wider = widenPriors(model, answer.fit);
  if (wider) {
    const Loss loss = answer.fit.loss;
    answer.fit = refit(used, *wider, answer.levels.noise, loss, std::move(answer.fit));
  }
  const Model& believed = wider ? *wider : model;
  CalibrationResult result = estimateUncertainty(used, believed, answer.fit, answer.levels);
  result.noiseSource = answer.source == NoiseSource::repeats ? "repeats" : "configured";
  result.restartsTried = options.restarts;
  if (options.robust && DisplacedBoardCount{used, result.outliers}.areTooMany()) {
    CalibrationOptions all = options;
    all.robust = false;
    all.start = result.unknowns;
    return calibrate(measurements, model, all);
  }
  if (answer.explained) {
    fillExplanations(*answer.explained, model, result);
  }
  if (options.robust && options.excludeDisplaced) {
    estimateBoardMoves(measurements, believed, answer.fit, result);
  }
  judgeResult(used, believed, result);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

} // namespace naocal
