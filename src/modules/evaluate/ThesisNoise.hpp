#pragma once

#include "evaluate/ThesisCell.hpp"
#include "residuals/Noise.hpp"
#include "synthetic/Randomness.hpp"

namespace naocal {

/// Where a joint stands when an angle was commanded, in the encoder's space, and what the encoder tells [rad].
struct AngleReading {
  double raw, reported;
};

/// The noise that a setting's measurements have and that our solver is told of. What is not noisy gets a little, so
/// that the problem stays regular: 0.01 px, 0.03 px where angles are noisy.
Noise thesisNoise(const ThesisSetting& setting, double pixel);

/// A joint that was commanded to an angle comes to stand within half a step of its encoder, which tells its angle with
/// the setting's noise, rounded to 12 bits (4.1). Exact where the setting has no joint noise.
AngleReading angleReading(double commanded, const ThesisSetting& setting, Randomness& chance);

} // namespace naocal
