#include "calibration/Calibration.hpp"

#include "calibration/BoardMoves.hpp"
#include "calibration/Fit.hpp"
#include "calibration/ModelAverage.hpp"
#include "calibration/ModelUncertainty.hpp"
#include "calibration/NoiseEstimation.hpp"
#include "calibration/Outliers.hpp"
#include "calibration/ReadingNoise.hpp"
#include "calibration/SharedCauses.hpp"
#include "calibration/Task.hpp"
#include "calibration/Uncertainty.hpp"
#include "calibration/result/Verdict.hpp"
#include "estimation/CandidateTerms.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
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
  std::vector<SharedCause> causes = {}; // of what an earlier search rejected
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

/// The analysis of missing effects. Where the base model's fit rejects measurements, they may share a cause that it
/// lacks: then a second search starts with all of them at full weight, and the shorter description of all measurements
/// counts, in which each rejected one has its price.
MissingEffectAnalysis explain(const Measurements& measurements, const Model& model, const NoiseConsistentFit& start,
                              const std::optional<RepeatInfo>& repeats, const CalibrationOptions& options) {
  constexpr double some = 0.005; // share: more than the tails of good corners
  MissingEffectAnalysis explained =
      analyseMissingEffects(measurements, model, start.fit, start.levels.noise, repeats, options);
  if (!options.robust || shareOfDoubtful(measurements, model, start.fit) <= some) {
    return explained;
  }
  try {
    const Fit whole = refit(measurements, model, start.levels.noise, Loss{}, start.fit, coarseTolerance);
    MissingEffectAnalysis other =
        analyseMissingEffects(measurements, model, whole, start.levels.noise, repeats, options);
    return describe(measurements, other) < describe(measurements, explained) ? std::move(other) : std::move(explained);
  } catch (const InputError&) { // a rejected corner comes to lie behind its camera
    return explained;
  }
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
    answer.explained = explain(measurements, model, answer, repeats, options);
    answer.levels = answer.explained->levels;
  }
  return answer;
}

/// Excludes, one at a time, observations whose board was displaced beyond doubt under any explanation: a tenth of all
/// at most, rounded up. Returns the remaining measurements, or nothing if none was excluded.
std::optional<Measurements> excludeMovedBoards(const Measurements& measurements, const Model& model,
                                               const CalibrationOptions& options, NoiseConsistentFit& answer) {
  constexpr double share = 0.1;
  const auto most = static_cast<std::size_t>(std::ceil(share * static_cast<double>(countViews(measurements))));
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

/// The measurements at the weights that the likeliest explanation gives them, displaced boards left out. Absent if all
/// count fully.
std::optional<Measurements> weigh(const Measurements& measurements, const Model& model,
                                  const CalibrationOptions& options, NoiseConsistentFit& answer) {
  std::optional<Measurements> kept =
      options.excludeDisplaced ? excludeMovedBoards(measurements, model, options, answer) : std::nullopt;
  const Measurements& used = kept ? *kept : measurements;
  std::optional<Measurements> weighed = answer.explained
                                            ? weighDoubtful(used, answer.explained->larger, answer.explained->largerFit)
                                            : weighDoubtful(used, model, answer.fit);
  return weighed ? std::move(weighed) : std::move(kept);
}

/// The fit of the model as given, at full weight of all that the likeliest explanation takes for sound: what the model
/// cannot explain stays in its errors. `used`: measurements with their weights.
Fit fitAtFullWeight(const Measurements& used, const Model& model, const NoiseConsistentFit& answer) {
  const Fit fit = refit(used, model, answer.levels.noise, Loss{}, answer.fit);
  return answer.explained && answer.explained->lacksMoreThanScatter() ? refitWithMisfitNoise(used, model, fit) : fit;
}

/// Explanations that are worth naming, likeliest first.
std::vector<Explanation> nameExplanations(std::vector<Explanation> explanations) {
  constexpr double worthNaming = 0.01;
  std::erase_if(explanations, [](const Explanation& one) { return one.weight <= worthNaming; });
  return explanations;
}

/// Fills the result's averages, explanations, remaining misfit and scatter from the analysis.
void fillExplanations(const MissingEffectAnalysis& explained, const ModelAverage& average, const Model& model,
                      CalibrationResult& result) {
  const Eigen::VectorXd sigmas = model.sigmas();
  for (const Eigen::Index i : average.unknowns()) {
    Estimate& estimate = result.estimates[static_cast<std::size_t>(i)];
    estimate.averaged = average.of(i);
    estimate.learned = std::max(0.0, 1 - estimate.averaged->sigma / sigmas[i]);
  }
  result.explanations = nameExplanations(average.explanations());
  result.misfitLeft = explained.window.misfit;
  result.scatter = explained.levels.scatter;
}

/// Measurements as given, at full weight, and as the likeliest explanation weighs them.
struct WeighedMeasurements {
  const Measurements &given, &used;
};

/// The result at the final noise levels and weights, and the tests of its fit if they were asked for.
std::pair<CalibrationResult, std::shared_ptr<const CandidateTests>> conclude(const WeighedMeasurements& measurements,
                                                                             const Model& model,
                                                                             const CalibrationOptions& options,
                                                                             NoiseConsistentFit& answer) {
  const Measurements& used = measurements.used;
  answer.fit = fitAtFullWeight(used, model, answer);
  const std::optional<Model> wider = widenPriors(model, answer.fit);
  if (wider) {
    answer.fit = refit(used, *wider, answer.levels.noise, Loss{}, std::move(answer.fit));
  }
  const Model& believed = wider ? *wider : model;
  CalibrationResult result = estimateUncertainty(used, believed, answer.fit, answer.levels);
  result.noiseSource = answer.source == NoiseSource::repeats ? "repeats" : "configured";
  result.restartsTried = options.restarts;
  std::optional<ModelAverage> average;
  std::shared_ptr<const CandidateTests> tests;
  if (answer.explained) {
    answer.explained->fit = answer.fit;
    tests = std::make_shared<const CandidateTests>(FittedModel{used, model, result},
                                                   testableTerms(used, model, options.effects), options.candidateTests);
    fillCompleteness(*tests, used.robot, result);
    average.emplace(*answer.explained, model);
    fillExplanations(*answer.explained, *average, model, result);
  }
  fillTask({used, believed, result}, average ? &*average : nullptr, options.tolerance, result);
  result.sharedCauses = std::move(answer.causes);
  if (options.robust && options.excludeDisplaced) {
    estimateBoardMoves(measurements.given, believed, answer.fit, result);
  }
  judgeResult(used, believed, result);
  return {std::move(result), std::move(tests)};
}

} // namespace

void requireUnknowns(const Measurements& measurements, const Model& model) {
  const bool asks = std::any_of(model.terms().begin(), model.terms().end(),
                                [](const Term& term) { return term.requested && !term.isPlacement; });
  if (!asks) {
    throw InputError{measurements.joints.empty()
                         ? "nothing to estimate: no joint moves what these captures measure; expected markers, boards "
                           "or cameras on links that joints move, check which links the file names"
                         : "nothing to estimate: expected at least one offset, camera or effect in the model, found "
                           "none; leave fewer out"};
  }
}

CalibrationResult calibrate(const Measurements& measurements, const Model& model, const CalibrationOptions& options) {
  return calibrateWeighing(measurements, model, options).result;
}

WeighedCalibration calibrateWeighing(const Measurements& measurements, const Model& model,
                                     const CalibrationOptions& options) {
  requireUnknowns(measurements, model);
  const auto begin = std::chrono::steady_clock::now();
  NoiseConsistentFit answer =
      fitWithNoise(measurements, model, options, fitInitially(measurements, model, options.noise, options));
  std::optional<Measurements> weighed = options.robust ? weigh(measurements, model, options, answer) : std::nullopt;
  std::vector<SharedCause> causes = weighed ? findSharedCauses(*weighed) : std::vector<SharedCause>{};
  if (!causes.empty()) { // no accidents: the search starts again with all measurements at full weight
    CalibrationOptions whole = options;
    whole.robust = false;
    whole.start = answer.fit.minimum.state.unknowns;
    weighed.reset();
    answer = fitWithNoise(measurements, model, whole, fitInitially(measurements, model, options.noise, whole));
    answer.causes = std::move(causes);
  }
  auto [result, tests] = conclude({measurements, weighed ? *weighed : measurements}, model, options, answer);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return {std::move(result), std::move(weighed), std::move(tests)};
}

} // namespace naocal
