#pragma once

#include "evaluation/thesis/ThesisSetting.hpp"
#include "math/Sampling.hpp"
#include "measurements/Noise.hpp"

namespace naocal {

/// Encoder-space angle that a joint actually reaches, and the reported reading [rad].
struct AngleReading {
  double raw, reported;
};

/// Noise of a drawn corner, 1 sigma per axis [px], where a single one has `pixel`: that of the mean of all that
/// coincide.
double cornerNoise(const ThesisSetting& setting, double pixel);

/// Measurement noise of a setting, known to our solver. Noiseless quantities get a small value to keep the problem
/// regular: 0.01 px, or 0.03 px if angles are noisy. The program's n samples of a pose, which share their corners'
/// noise, have cornerNoise * sqrt(n): together they tell what one does.
Noise thesisNoise(const ThesisSetting& setting, double pixel);

/// Simulates a commanded joint: it stops within half an encoder step of the command; the reading has the setting's
/// noise and is rounded to 12 bits (4.1). Exact without joint noise.
AngleReading readAngle(double commanded, const ThesisSetting& setting, RandomStream& chance);

} // namespace naocal
