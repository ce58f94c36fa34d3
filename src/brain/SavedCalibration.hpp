#pragma once

#include "calibrate/ResultFile.hpp"
#include "framework/Configuration.hpp"

namespace naocal {

/// What a result says of neck and cameras; the rest is as drawn.
StoredResult ofHead(StoredResult result);

/// The joints' offsets and the cameras' mounts as they are configured now.
StoredResult configured(const Configuration& configuration);

/// Sets and saves the joints' offsets (Motion.JointCalibrationProvider, degrees) and the cameras' mounts
/// (Brain.Projection, radians) that a result holds; both hip yaw-pitches get their one motor's. Throws what the
/// configuration throws.
void apply(const StoredResult& result, Configuration& configuration);

/// Undoes what `apply` saved. Throws ConfigurationError where nothing was.
void takeBack(Configuration& configuration);

} // namespace naocal
