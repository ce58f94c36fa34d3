#pragma once

#include "calibration/EffectiveOffsets.hpp"
#include "calibration/result/ResultFile.hpp"
#include "framework/configuration/Configuration.hpp"

#include <map>
#include <string>

namespace naocal {

/// The offsets of the neck.
std::vector<EffectiveOffset> headOffsets(std::vector<EffectiveOffset> offsets);

/// The configured joint offsets and camera mounts.
StoredResult readConfiguredCalibration(const Configuration& configuration);

/// The configured joint offsets by joint [rad].
std::map<std::string, double> readConfiguredOffsets(const Configuration& configuration);

/// The keys of both mounts in their current state, as JSON for `restoreCalibration`.
std::string snapshotCalibration(const Configuration& configuration);

/// Applies joint offsets (Motion.JointCalibrationProvider, degrees) and the camera mounts of a result
/// (Brain.Projection, radians) without saving; both hip yaw-pitches get the offset of their common motor. Rethrows
/// exceptions of the configuration after restoring the previous values.
void applyCalibration(const std::vector<EffectiveOffset>& offsets, const StoredResult& mounts,
                      Configuration& configuration);
/// Applies a camera's lens (Brain.Projection) without saving; its distortion has no place there.
void applyLens(const std::string& camera, const CameraIntrinsics& lens, Configuration& configuration);

void restoreCalibration(const std::string& calibrationKeys, Configuration& configuration);

/// Mounts both files of a configuration that no robot process runs on, grouped. Offsets beyond `largestOffset` are
/// refused.
void mountCalibration(Configuration& configuration);

/// Groups both mounts: they are always saved and undone together.
void saveCalibrationTogether(Configuration& configuration);

/// Whether both mounts have no unsaved changes; save or undo both. Throw ConfigurationError on failure.
bool isCalibrationSaved(const Configuration& configuration);
void saveCalibration(Configuration& configuration);
void undoCalibration(Configuration& configuration);

} // namespace naocal
