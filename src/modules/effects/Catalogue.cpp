#include "effects/Catalogue.hpp"

namespace naocal {

const std::vector<Effect>& allEffects() {
  static const std::vector<Effect> all{jointOffset(),    encoderGain(),       encoderEccentricity(),
                                       thermalDrift(),   timeDrift(),         backlash(),
                                       hysteresis(),     gearPlay(),          elasticity(),
                                       motorCoupling(),  lateralElasticity(), timeOffset(),
                                       axisTilt(),       linkLength(),        linkGeometry(),
                                       soleCompliance(), soleTilt(),          imuTilt(),
                                       cameraRotation(), cameraTranslation(), focalLength(),
                                       principalPoint(), radialDistortion(),  tangentialDistortion(),
                                       rollingShutter(), boardScale(),        boardBow(),
                                       boardTilt(),      trackerScale(),      trackerDrift()};
  return all;
}

} // namespace naocal
