#pragma once

#include "calibrate/Calibration.hpp"
#include "solve/LevenbergMarquardt.hpp"

namespace naocal {

using FitMinimum = Minimum<Residuals::State, Residuals::Linear>;

/// The least cost of a model under one noise level and one loss.
struct Fit {
  Noise noise;
  Loss loss;
  FitMinimum minimum;
  bool restartsChanged = false;
};

/// From far: quadratic loss, from the start of `options` and as many random ones as it asks for.
Fit firstFit(const Measurements& measurements, const Model& model, const Noise& noise,
             const CalibrationOptions& options);

/// On from a fit, under another noise level or loss.
Fit refit(const Measurements& measurements, const Model& model, const Noise& noise, const Loss& loss, Fit from);

/// On from a fit: corners far off their prediction lose their weight. The loss's scale follows the median distance, so
/// that a model that misses something is not mistaken for a board full of false corners.
Fit robustFit(const Measurements& measurements, const Model& model, const Noise& noise, Fit from);

} // namespace naocal
