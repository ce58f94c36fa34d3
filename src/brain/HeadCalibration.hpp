#pragma once

#include "calibrate/ResultFile.hpp"
#include "framework/Configuration.hpp"
#include "hardware/exchange/CompensatedAngles.hpp"

#include <vector>

namespace naocal {

/// The stand with the head at each pair of these angles [deg], row by row of pitches, back and forth.
std::vector<CompensatedAngles> headPoses(const CompensatedAngles& stand, const std::vector<double>& yaws,
                                         const std::vector<double>& pitches);

/// What a result says of neck and cameras; the rest is as drawn.
StoredResult ofHead(StoredResult result);

/// Sets and saves the joints' offsets (Motion.JointCalibrationProvider, degrees) and the cameras' mounts
/// (Brain.Projection, radians) that a result holds. Throws what the configuration throws.
void apply(const StoredResult& result, Configuration& configuration);

/// Undoes what `apply` saved.
void takeBack(Configuration& configuration);

} // namespace naocal
