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
constexpr double gearFriction = 0.2; // [Nm], offset of the unknown t of gearPlay
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

/// All effects in causal order: encoders, gears, links, soles, IMU, mounts, lenses, boards.
const std::vector<Effect>& allEffects();

} // namespace naocal
