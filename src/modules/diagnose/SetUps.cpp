#include "diagnose/SetUps.hpp"

#include "captures/InputError.hpp"
#include "geometry/Angles.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace naocal {

namespace {

constexpr double nonsense = 100;           // [px]: neither physics nor an accident does this
constexpr double good = 5;                 // [px]: of a set that is right but for its physics
constexpr double mends = 0.4;              // of the misfit must be left at most
constexpr double mostOffset = radians(15); // of a robot that still stands
constexpr double some = 0.1;               // of all corners: more than a few pictures that belong elsewhere

/// rms distance of corners when these sets are fitted [px]; absent when they cannot be.
std::optional<double> misfitOf(const std::vector<CaptureSet>& sets, const Measurements& asTheyAre) {
  try {
    const Measurements measurements = measurementsOf(sets, asTheyAre.robot, asTheyAre.samePlace);
    CalibrationOptions options;
    options.estimateNoise = options.question = false;
    options.robust = false;
    return calibrate(measurements, makeModel(measurements), options).rmsPx;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::vector<CaptureSet> mirrored(std::vector<CaptureSet> sets, const std::string& joint) {
  for (CaptureSet& set : sets) {
    const auto found = std::find(set.jointNames.begin(), set.jointNames.end(), joint);
    for (Capture& capture : set.captures) {
      if (found != set.jointNames.end()) {
        double& angle = capture.joints.measured[static_cast<std::size_t>(found - set.jointNames.begin())];
        angle = -angle;
      }
    }
  }
  return sets;
}

std::vector<CaptureSet> camerasSwapped(std::vector<CaptureSet> sets) {
  for (CaptureSet& set : sets) {
    for (Capture& capture : set.captures) {
      capture.camera = capture.camera == "top" ? "bottom" : "top";
    }
  }
  return sets;
}

} // namespace

GrossMisfit GrossMisfit::of(const CalibrationResult& fit, const Model& model) {
  double all = 0, far = 0;
  for (const SightingResidual& sighting : fit.asReported) {
    all += static_cast<double>(sighting.residual.cols());
    far += static_cast<double>((sighting.residual.colwise().norm().array() > impossible).count());
  }
  const bool absurd = std::any_of(model.terms().begin(), model.terms().end(), [&](const Term& term) {
    return term.effect.name == "jointOffset" &&
           std::abs(fit.unknowns[static_cast<Eigen::Index>(term.first)]) > mostOffset;
  });
  return {.rmsPx = fit.rmsPx, .farShare = far / std::max(1.0, all), .absurd = absurd || fit.rmsPx > impossible};
}

std::optional<Suspicion> wrongSetUp(const std::vector<CaptureSet>& sets, const Measurements& measurements,
                                    const GrossMisfit& misfit, const std::function<bool(std::size_t)>& mayBeMirrored) {
  if (misfit.rmsPx < gross) {
    return std::nullopt;
  }
  std::optional<Suspicion> best;
  double least = std::min({mends * std::min(misfit.rmsPx, impossible), good, misfit.explainedPx});
  const auto consider = [&](const std::vector<CaptureSet>& corrected, const std::string& why) {
    if (const auto left = misfitOf(corrected, measurements); left && *left < least) {
      least = *left;
      best = Suspicion{{}, fmt::format("{} (so corrected the error is {:.1f} px)", why, *left)};
    }
  };
  for (std::size_t joint : measurements.joints) {
    const std::string& name = measurements.robot.joints[joint].name;
    if (misfit.absurd || mayBeMirrored(joint)) {
      consider(mirrored(sets, name), fmt::format("{}'s angles have the wrong sign", name));
    }
  }
  if (sets.front().cameras.size() == 2) {
    consider(camerasSwapped(sets), "the cameras' names are swapped");
  }
  if (!best && misfit.rmsPx > nonsense && misfit.farShare > some && std::isfinite(misfit.rmsPx)) {
    best = Suspicion{{},
                     fmt::format("predictions are {:.0f} px off and no robot is so wrong: a board of another pattern "
                                 "(legacyPattern), other boards or another robot than the file says",
                                 misfit.rmsPx)};
  }
  return best;
}

} // namespace naocal
