#pragma once

#include "calibration/EffectiveOffsets.hpp"
#include "calibration/result/ResultFile.hpp"
#include "dialects/RobotCalibration.hpp"
#include "robot/Robot.hpp"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace naocal {

/// A calibration on its way to a robot: from a result of `naocal solve`, or from a file of `naocal import`.
struct LoadedCalibration {
  RobotCalibration calibration;          // one constant per joint that is learned, mounts and lenses
  std::vector<JointCompensation> joints; // of a result, all joints of its model
  std::vector<std::string> unlearned;    // joints left out: hardly learned (isLearned)
  std::vector<std::string> otherTerms;   // of a result: effects that no constant of a joint or mount expresses
  StoredResult result;                   // of an imported file: empty
  std::vector<std::string> folders;      // of the captures, where they are now; empty: not found, or not needed
  Robot robot;
  bool lensIsEstimated = false; // an effect of the model changes a lens
};

/// Options on where a result's captures are and which posture its constants are for.
struct PostureOptions {
  std::vector<std::string> sets;   // folders; empty: those that the result names
  std::string pose;                // a .pose file; empty: standing with bent knees
  std::vector<std::string> lookIn; // folders to search for moved captures
};

/// Adds --at, --set and --look-in to a command.
void addPostureOptions(CLI::App& command, PostureOptions& options);

/// Reads the file. A result whose model has further effects at joints needs its captures, for o - delta at the posture.
/// Throws InputError for a result that should not be used, and where captures are missing.
LoadedCalibration loadCalibration(const std::string& file, const PostureOptions& options);

/// The folders of a result's captures; empty if one is not found as it was. Tells on standard error which were moved.
std::vector<std::string> findCaptureFolders(const StoredResult& result, const std::string& file,
                                            const PostureOptions& options);

/// Whether the captures told an unknown of a result ("jointOffset@LKneePitch.o"): at least 50 % learned.
bool isLearned(const StoredResult& result, const std::string& unknown);

/// Throws InputError for a result that should not be used.
void requireUsable(const StoredResult& result, const std::string& file);

/// Prints o, delta at the posture, its spread over the captures and the constant, for joints with a delta; then what
/// constants cannot correct.
void printCompensations(const LoadedCalibration& loaded);

/// The same as JSON, by joint [rad].
nlohmann::json compensationsJson(const LoadedCalibration& loaded);

} // namespace naocal
