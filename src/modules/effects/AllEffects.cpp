#include "effects/AllEffects.hpp"

namespace naocal {

const std::vector<Effect>& allEffects() {
  static const std::vector<Effect> all{jointOffset(),
                                       encoderGain(),
                                       encoderEccentricity(),
                                       thermalDrift(),
                                       timeDrift(),
                                       backlash(),
                                       hysteresis(),
                                       elasticity(),
                                       timeOffset(),
                                       axisTilt(),
                                       linkLength(),
                                       soleCompliance(),
                                       soleTilt(),
                                       cameraRotation(),
                                       cameraTranslation(),
                                       focalLength(),
                                       principalPoint(),
                                       radialDistortion(),
                                       tangentialDistortion(),

                                       boardScale(),
                                       boardBow(),
                                       boardTilt()};
  return all;
}

} // namespace naocal
