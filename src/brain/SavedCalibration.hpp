#pragma once

#include "brain/GearPlay.hpp"
#include "calibrate/ResultFile.hpp"
#include "framework/Configuration.hpp"

namespace naocal {

/// Those of the neck.
std::vector<ShownOffset> ofHead(std::vector<ShownOffset> offsets);

/// The joints' offsets and the cameras' mounts as they are configured now.
StoredResult configured(const Configuration& configuration);

/// Sets and saves the joints' offsets (Motion.JointCalibrationProvider, degrees) and the cameras' mounts of a result
/// (Brain.Projection, radians); both hip yaw-pitches get their one motor's. Throws what the configuration throws.
void apply(const std::vector<ShownOffset>& offsets, const StoredResult& mounts, Configuration& configuration);

/// Undoes what `apply` saved. Throws ConfigurationError where nothing was.
void takeBack(Configuration& configuration);

} // namespace naocal
