#include "evaluate/ThesisNoise.hpp"

#include "geometry/Angles.hpp"

#include <cmath>

namespace naocal {

namespace {

/// Before rounding [rad].
double angleSigma(AngleNoise noise) {
  return noise == AngleNoise::radians ? 0.007 : noise == AngleNoise::degrees ? radians(0.007) : 0;
}

} // namespace

Noise thesisNoise(const ThesisSetting& setting, double pixel) {
  const double noPixelNoise = setting.angleNoise() ? 0.03 : 0.01; // [px]
  const bool dithered = setting.jointNoise == AngleNoise::encoder;
  const double rounding = encoderStep / std::sqrt(dithered ? 6.0 : 12.0); // uniform, or a sum of two uniform ones
  return {.pixel = setting.pixelNoise() ? pixel : noPixelNoise,
          .encoder = setting.angleNoise() ? std::hypot(angleSigma(setting.jointNoise), rounding) : 0,
          .pose = 0};
}

AngleReading angleReading(double commanded, const ThesisSetting& setting, Randomness& chance) {
  if (!setting.angleNoise()) {
    return {commanded, commanded};
  }
  const double raw = commanded + chance.within(encoderStep / 2);
  const bool dithered = setting.jointNoise == AngleNoise::encoder;
  const double noise = dithered ? chance.within(encoderStep / 2) : chance.normal(angleSigma(setting.jointNoise));
  return {raw, encoderStep * std::round((raw + noise) / encoderStep)};
}

} // namespace naocal
