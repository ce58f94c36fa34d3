#pragma once

#include "effects/Effect.hpp"

#include <vector>

namespace naocal {

Effect jointOffset();
Effect cameraRotation();
Effect cameraTranslation();
Effect focalLength();
Effect principalPoint();
Effect radialDistortion();
Effect tangentialDistortion();

/// Every effect, in the order in which causes act: joints, mounts, lens.
const std::vector<Effect>& allEffects();

} // namespace naocal
