#include "calibrate/Calibration.hpp"

#include "calibrate/Doubts.hpp"
#include "calibrate/Fit.hpp"
#include "calibrate/MovedSightings.hpp"
#include "calibrate/PixelNoise.hpp"
#include "calibrate/Uncertainty.hpp"
#include "calibrate/Verdict.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

namespace naocal {

namespace {

/// Noise levels that the captures themselves tell; the others stay as configured.
struct Levels {
  JointNoise joint;
  bool fromRepeats = false;
};

Levels levels(const Measurements& measurements, const Model& model, const Fit& fit, const CalibrationOptions& options) {
  Levels result{{options.noise}, false};
  if (!options.estimateNoise) {
    return result;
  }
  Noise& noise = result.joint.noise;
  const Residuals residuals{measurements, model, fit.noise, fit.loss};
  const std::vector<SightingResidual> sightings = residuals.sightings(fit.minimum.state);
  if (const auto repeats = pixelNoiseFromRepeats(measurements, sightings)) {
    result.fromRepeats = true;
    const double within = pixelNoiseWithinPictures(sightings).value_or(*repeats);
    const double beyondRepeats = std::sqrt(std::max(0.0, within * within - *repeats * *repeats));
    const double alike = std::clamp(beyondRepeats, options.repeatedCornerError, options.largestCornerError);
    noise.pixel = std::max(std::hypot(*repeats, alike), options.largestCornerError);
    const auto some = [&](bool PoseGroup::*kind) {
      return std::any_of(measurements.poses.begin(), measurements.poses.end(), std::mem_fn(kind));
    };
    result.joint = jointNoise(fit.minimum.linear, fit.minimum.state.unknowns, model.sigmas(), noise,
                              {.reapproached = some(&PoseGroup::repeated), .restood = some(&PoseGroup::restood)});
  } else if (!options.pixelGiven) {
    noise.pixel = pixelNoiseWithinPictures(sightings).value_or(noise.pixel);
  }
  return result;
}

/// Fit, noise levels and misfit that belong together.
struct Answer {
  Fit fit;
  Levels levels;
  Misfit misfit;
};

/// On from an answer: fit and noise levels in turns.
Answer improved(const Measurements& measurements, const Model& model, const CalibrationOptions& options, Answer from) {
  const auto onward = [&] {
    const Noise& noise = from.levels.joint.noise;
    return options.robust ? robustFit(measurements, model, noise, std::move(from.fit))
                          : refit(measurements, model, noise, Loss{}, std::move(from.fit), roughly);
  };
  for (int round = 0; round < 2; ++round) {
    from.fit = onward();
    from.levels = levels(measurements, model, from.fit, options);
  }
  from.fit = onward();
  from.misfit = misfitOf(from.fit, model.sigmas());
  if (from.misfit.scale > 1) { // then priors must not be beaten by noise that is larger than it was believed
    from.levels.joint.noise = scaled(from.levels.joint.noise, from.misfit.scale);
    from.fit = onward();
  }
  const Loss loss = from.fit.loss;
  from.fit = refit(measurements, model, from.levels.joint.noise, loss, std::move(from.fit)); // to the last digit
  return from;
}

/// Sets aside, one after the other, sightings whose board moved beyond doubt. Where more than a tenth seem to, it is
/// the model that is wrong, not the captures. Returns the measurements that are left, if any were set aside.
std::optional<Measurements> withoutMoved(const Measurements& measurements, const Model& model,
                                         const CalibrationOptions& options, Answer& answer) {
  std::size_t sightings = 0;
  for (const Picture& picture : measurements.pictures) {
    sightings += picture.sightings.size();
  }
  std::optional<Measurements> kept;
  for (std::size_t aside = 0; aside < (sightings + 9) / 10; ++aside) {
    const auto moved = mostMoved(kept ? *kept : measurements, model, answer.fit);
    if (!moved) {
      break;
    }
    if (!kept) {
      kept = measurements;
    }
    setAside(*kept, *moved);
    answer = improved(*kept, model, options, std::move(answer));
  }
  return kept;
}

} // namespace

CalibrationResult calibrate(const Measurements& measurements, const Model& model, const CalibrationOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  Answer answer{firstFit(measurements, model, options.noise, options), {{options.noise}, false}, {}};
  answer = improved(measurements, model, options, std::move(answer));
  const auto kept =
      options.robust && options.setAside ? withoutMoved(measurements, model, options, answer) : std::nullopt;
  const Measurements& used = kept ? *kept : measurements;
  CalibrationResult result = uncertain(used, model, answer.fit, answer.levels.joint, answer.misfit);
  result.noiseSource = answer.levels.fromRepeats ? "repeats" : "configured";
  result.restartsTried = options.restarts;
  result.doubts = doubts(used, result);
  judge(used, model, result);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

} // namespace naocal
