#include "evaluate/ThesisNoise.hpp"

#include "math/Angles.hpp"

#include <cmath>

namespace naocal {

namespace {

/// Before rounding [rad].
double angleSigma(AngleNoise noise) {
  return noise == AngleNoise::radians ? 0.007 : noise == AngleNoise::degrees ? radians(0.007) : 0;
}

/// Of a gear that sticks, behind the encoder: half the dead zone of a motor [rad].
const double stiction = radians(0.05);

bool dithered(const ThesisSetting& setting) {
  return setting.jointNoise == AngleNoise::encoder || setting.jointNoise == AngleNoise::stiction;
}

} // namespace

Noise thesisNoise(const ThesisSetting& setting, double pixel) {
  const double noPixelNoise = setting.angleNoise() ? 0.03 : 0.01; // [px]
  const double rounding =
      encoderStep / std::sqrt(dithered(setting) ? 6.0 : 12.0); // uniform, or a sum of two uniform ones
  return {.pixel = setting.pixelNoise() ? pixel : noPixelNoise,
          .encoder = setting.angleNoise() ? std::hypot(angleSigma(setting.jointNoise), rounding) : 0,
          .pose = setting.angleNoise() && setting.jointNoise == AngleNoise::stiction ? stiction : 0};
}

AngleReading angleReading(double commanded, const ThesisSetting& setting, Randomness& chance) {
  if (!setting.angleNoise()) {
    return {commanded, commanded};
  }
  const double raw = commanded + chance.within(encoderStep / 2);
  const double noise =
      dithered(setting) ? chance.within(encoderStep / 2) : chance.normal(angleSigma(setting.jointNoise));
  const double behind = setting.jointNoise == AngleNoise::stiction ? chance.normal(stiction) : 0;
  return {raw + behind, encoderStep * std::round((raw + noise) / encoderStep)};
}

} // namespace naocal
