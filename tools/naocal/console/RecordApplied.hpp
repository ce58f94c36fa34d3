#pragma once

#include "calibration/result/ResultFile.hpp"
#include "console/RobotCalibrationFile.hpp"
#include "framework/configuration/Configuration.hpp"
#include "runs/Run.hpp"

#include <filesystem>
#include <map>
#include <string>

namespace naocal {

/// Help of the option that names the state folder.
inline constexpr const char* stateHelp =
    "folder with the recorded runs in runs/; $XDG_STATE_HOME/naocal or ~/.local/state/naocal if not given";

/// The folder of runs in the state folder of --state, or in the user's. Throws InputError if there is neither.
std::filesystem::path runsFolder(const std::string& state);

/// The configured calibration before a result is applied or taken back.
struct ConfiguredBefore {
  StoredResult calibration;
  std::map<std::string, double> offsets; // by joint [rad]
};
ConfiguredBefore readBefore(const Configuration& configuration);

/// A result that was written into a robot's configuration, or taken back (`isUndo`).
struct AppliedResult {
  std::string result, state; // file; option --state
  bool isUndo;
  RunRobot robot;
};

/// Records it as a run: offsets with sigmas, and the error on the result's captures before and after where those are
/// there. Returns the run's file; empty, after a sentence on standard error, if it could not be recorded.
std::string recordApplied(const AppliedResult& applied, const LoadedCalibration& loaded, const ConfiguredBefore& before,
                          const Configuration& after);

} // namespace naocal
