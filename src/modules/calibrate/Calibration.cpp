#include "calibrate/Calibration.hpp"

#include "calibrate/Doubts.hpp"
#include "calibrate/Fit.hpp"
#include "calibrate/PixelNoise.hpp"
#include "calibrate/Uncertainty.hpp"
#include "calibrate/Verdict.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace naocal {

namespace {

/// What a corner's fit is off by in every picture of a pose alike, and repeats cannot show: its place between the
/// pixels stays (rendered pictures: 0.02 px where boards are near) [px].
constexpr double repeatedCornerError = 0.02;

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
    noise.pixel = std::hypot(*repeats, repeatedCornerError);
    const bool encoderToo = std::any_of(measurements.poses.begin(), measurements.poses.end(),
                                        [](const PoseGroup& pose) { return pose.repeated; });
    result.joint = jointNoise(fit.minimum.linear, fit.minimum.state.unknowns, model.sigmas(), noise, encoderToo);
  } else if (!options.pixelGiven) {
    noise.pixel = pixelNoiseWithinPictures(sightings).value_or(noise.pixel);
  }
  return result;
}

} // namespace

CalibrationResult calibrate(const Measurements& measurements, const Model& model, const CalibrationOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  Fit fit = firstFit(measurements, model, options.noise, options);
  Levels found{{options.noise}, false};
  const auto onward = [&] {
    const Noise& noise = found.joint.noise;
    return options.robust ? robustFit(measurements, model, noise, std::move(fit))
                          : refit(measurements, model, noise, Loss{}, std::move(fit));
  };
  for (int round = 0; round < 2; ++round) {
    fit = onward();
    found = levels(measurements, model, fit, options);
  }
  fit = onward();
  const Misfit misfit = misfitOf(fit, model.sigmas());
  if (misfit.scale > 1) { // then priors must not be beaten by noise that is larger than it was believed
    found.joint.noise = scaled(found.joint.noise, misfit.scale);
    fit = onward();
  }
  CalibrationResult result = uncertain(measurements, model, fit, found.joint, misfit);
  result.noiseSource = found.fromRepeats ? "repeats" : "configured";
  result.restartsTried = options.restarts;
  result.doubts = doubts(measurements, result);
  judge(measurements, model, result);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

} // namespace naocal
