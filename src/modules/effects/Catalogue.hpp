#pragma once

#include "effects/Effect.hpp"

#include <vector>

namespace naocal {

/// Names of effects that code elsewhere singles out.
namespace effectName {
inline constexpr char jointOffset[] = "jointOffset";
inline constexpr char cameraRotation[] = "cameraRotation";
inline constexpr char encoderGain[] = "encoderGain";
inline constexpr char elasticity[] = "elasticity";
inline constexpr char spring[] = "spring"; // alias of elasticity in files
inline constexpr char hysteresis[] = "hysteresis";
inline constexpr char gearPlay[] = "gearPlay";
inline constexpr char boardPlacement[] = "boardPlacement";
inline constexpr char stancePlacement[] = "stancePlacement";
inline constexpr char cameraPlacement[] = "cameraPlacement";
inline constexpr char trackerPlacement[] = "trackerPlacement";
inline constexpr char markerPoint[] = "markerPoint";
inline constexpr char framePlacement[] = "framePlacement";
inline constexpr char placePoint[] = "placePoint";
inline constexpr char cameraTranslation[] = "cameraTranslation";
inline constexpr char encoderEccentricity[] = "encoderEccentricity";
inline constexpr char motorCoupling[] = "motorCoupling";
inline constexpr char linkGeometry[] = "linkGeometry";
} // namespace effectName

/// One function per effect of the catalogue; each describes itself in its file in effects/catalogue/.
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
Effect lateralElasticity();
/// `other`: the joint that drives this one along.
Effect motorCoupling(std::size_t other = 0);
Effect timeOffset();
Effect axisTilt();
Effect linkLength();
Effect linkGeometry();
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
Effect trackerScale();
Effect trackerDrift();

/// All effects in causal order: encoders, gears, links, soles, IMU, mounts, lenses, boards, trackers.
const std::vector<Effect>& allEffects();

} // namespace naocal
