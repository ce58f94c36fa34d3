#pragma once

#include "calibration/Fit.hpp"
#include "calibration/result/CalibrationResult.hpp"

namespace naocal {

/// The largest noise that an instrument of this kind has [m] or [rad]: the upper end of what is estimated.
double mostNoiseOf(const ReadingLevel& level);

/// Sum of 2 ln sigma over all scalar readings with a weight: the part of -2 ln likelihood that depends on the noise
/// levels alone.
double logNoiseOfReadings(const Measurements& measurements, const Noise& noise);

/// Estimates the noise levels of readings (`Measurements::levels`) that the sets do not give, one after the other, and
/// the scatter from pose to pose along with them, by restricted likelihood: with V the covariance of all rows, H the
/// information of all unknowns and g the gradient,
///
///   D = ln |V| + ln |H| + 2 cost - g^T H^-1 g + penalty of the scatter.
///
/// `model` is extended by all candidate effects, whose priors are their plausible sizes: a missing effect would
/// otherwise pass for noise. Returns `noise` with the levels; empty ones if the sets give all.
Noise estimateReadingNoise(const Measurements& measurements, const Model& model, const Fit& fit, Noise noise,
                           const std::vector<Effect>& effects);

} // namespace naocal
