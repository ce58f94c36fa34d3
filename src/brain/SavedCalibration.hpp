#pragma once

#include "calibration/EffectiveOffsets.hpp"
#include "calibration/ResultFile.hpp"
#include "framework/configuration/Configuration.hpp"

namespace naocal {

/// Those of the neck.
std::vector<ShownOffset> headOffsets(std::vector<ShownOffset> offsets);

/// The joints' offsets and the cameras' mounts as they are configured now.
StoredResult readConfiguredCalibration(const Configuration& configuration);

/// The keys of both as they are set now, to be put back.
std::string snapshotCalibration(const Configuration& configuration);

/// Puts into effect the joints' offsets (Motion.JointCalibrationProvider, degrees) and the cameras' mounts of a result
/// (Brain.Projection, radians); both hip yaw-pitches get their one motor's. Nothing is saved. Throws what the
/// configuration throws; nothing has changed then.
void applyCalibration(const std::vector<ShownOffset>& offsets, const StoredResult& mounts,
                      Configuration& configuration);
void restoreCalibration(const std::string& calibrationKeys, Configuration& configuration);

/// From now on neither is saved or undone without the other, whoever asks for it.
void saveCalibrationTogether(Configuration& configuration);

/// Saves both, and undoes what was saved last. Throw ConfigurationError where that cannot be.
bool isCalibrationSaved(const Configuration& configuration); // as it is now
void saveCalibration(Configuration& configuration);
void undoCalibration(Configuration& configuration);

} // namespace naocal
