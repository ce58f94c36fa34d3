#pragma once

#include "calibration/EffectiveOffsets.hpp"
#include "calibration/result/ResultFile.hpp"
#include "dialects/RobotCalibration.hpp"
#include "robot/Robot.hpp"

#include <functional>
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

/// Options on where a result's captures are, which posture its constants are for, and whether it may be used.
struct PostureOptions {
  std::vector<std::string> sets;   // folders; empty: those that the result names
  std::string pose;                // a .pose file; empty: standing with bent knees
  std::vector<std::string> lookIn; // folders to search for moved captures
  bool force = false;              // write what should not be used, too
};

/// Adds --at, --set, --look-in and --force to a command.
void addPostureOptions(CLI::App& command, PostureOptions& options);

/// Reads the file. A result whose model has further effects at joints needs its captures, for o - delta at the posture.
/// Throws RefusedCalibration for one that should not be used, unless forced, and InputError where captures are missing.
LoadedCalibration loadCalibration(const std::string& file, const PostureOptions& options);

/// The folders of a result's captures; empty if one is not found as it was. Tells on standard error which were moved.
std::vector<std::string> findCaptureFolders(const StoredResult& result, const std::string& file,
                                            const PostureOptions& options);

/// Whether the captures told an unknown of a result ("jointOffset@LKneePitch.o"): at least 50 % learned.
bool isLearned(const StoredResult& result, const std::string& unknown);

/// A calibration that must not be written to a robot.
struct RefusedCalibration {
  std::string file;
  std::vector<std::string> reasons; // one sentence each
};

/// Throws RefusedCalibration if there are reasons against writing the file's calibration; if `force`, prints them on
/// standard error instead.
void requireNoReasons(const std::string& file, const std::vector<std::string>& reasons, bool force);

/// Runs a command that writes a calibration. Exit code: 0, or 3 after a refusal, whose reasons are printed on standard
/// error, one a line.
int writeUnlessRefused(const std::function<void()>& write);

/// Prints o, delta at the posture, its spread over the captures and the constant, for joints with a delta; then what
/// constants cannot correct.
void printCompensations(const LoadedCalibration& loaded);

/// The same as JSON, by joint [rad].
nlohmann::json compensationsJson(const LoadedCalibration& loaded);

} // namespace naocal
