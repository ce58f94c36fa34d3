#pragma once

#include "effects/Effect.hpp"

#include <vector>

namespace naocal {

Effect jointOffset();
Effect encoderGain();
Effect encoderEccentricity();
Effect thermalDrift();
Effect timeDrift();
Effect backlash();
Effect hysteresis();
Effect gearPlay();
Effect elasticity();
Effect timeOffset();
Effect axisTilt();
Effect linkLength();
Effect soleCompliance();
Effect soleTilt();
Effect imuTilt();
Effect cameraRotation();
Effect cameraTranslation();
Effect focalLength();
Effect principalPoint();
Effect radialDistortion();
Effect tangentialDistortion();
Effect rollingShutter();
Effect boardScale();
Effect boardBow();
Effect boardTilt();

/// Every effect, in the order in which causes act: encoders, gears, links, soles, the inertial unit, mounts, lenses,
/// boards.
const std::vector<Effect>& allEffects();

} // namespace naocal
