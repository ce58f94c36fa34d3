#include "effects/AllEffects.hpp"

namespace naocal {

const std::vector<Effect>& allEffects() {
  static const std::vector<Effect> all{jointOffset(),    cameraRotation(),   cameraTranslation(),   focalLength(),
                                       principalPoint(), radialDistortion(), tangentialDistortion()};
  return all;
}

} // namespace naocal
