#include "evaluation/thesis/NoiseOfSetting.hpp"

#include "evaluation/thesis/ThesisScene.hpp"
#include "math/Angles.hpp"

#include <cmath>

namespace naocal {

namespace {

/// Noise before rounding, 1 sigma [rad].
double angleSigma(AngleNoise noise) {
  return noise == AngleNoise::radians     ? 0.007
         : noise == AngleNoise::degrees   ? radians(0.007)
         : noise == AngleNoise::unrounded ? programAngleNoise
                                          : 0;
}

/// Deflection of a sticking gear behind the encoder, 1 sigma: half a motor's dead zone [rad].
const double stiction = radians(0.05);

bool isDithered(const ThesisSetting& setting) {
  return setting.jointNoise == AngleNoise::encoder || setting.jointNoise == AngleNoise::stiction;
}

} // namespace

double cornerNoise(const ThesisSetting& setting, double pixel) {
  return pixel / std::sqrt(static_cast<double>(copiesOf(setting.feature)));
}

Noise thesisNoise(const ThesisSetting& setting, double pixel) {
  const double noPixelNoise = setting.angleNoise() ? 0.03 : 0.01; // [px]
  const double rounding =
      setting.likeProgram() ? 0 : encoderStep / std::sqrt(isDithered(setting) ? 6.0 : 12.0); // one uniform error, or
                                                                                             // the sum of two
  const double sharing = setting.likeProgram() ? static_cast<double>(setting.samples) : 1;
  return {.pixel = setting.pixelNoise() ? cornerNoise(setting, pixel) * std::sqrt(sharing) : noPixelNoise,
          .encoder = setting.angleNoise() ? std::hypot(angleSigma(setting.jointNoise), rounding) : 0,
          .pose = setting.angleNoise() && setting.jointNoise == AngleNoise::stiction ? stiction : 0};
}

AngleReading readAngle(double commanded, const ThesisSetting& setting, RandomStream& chance) {
  if (!setting.angleNoise()) {
    return {commanded, commanded};
  }
  if (setting.likeProgram()) {
    return {commanded + chance.normal(programAngleNoise), commanded};
  }
  const double raw = commanded + chance.uniformWithin(encoderStep / 2);
  const double noise =
      isDithered(setting) ? chance.uniformWithin(encoderStep / 2) : chance.normal(angleSigma(setting.jointNoise));
  const double behind = setting.jointNoise == AngleNoise::stiction ? chance.normal(stiction) : 0;
  return {raw + behind, encoderStep * std::round((raw + noise) / encoderStep)};
}

} // namespace naocal
