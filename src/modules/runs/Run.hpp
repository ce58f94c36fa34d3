#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

using RunTime = std::chrono::sys_seconds; // UTC, of the computer that recorded the run

/// The robot of a run. Joints belong to the body; heads and bodies are exchanged separately.
struct RunRobot {
  std::string body, head;     // names of id_map.json, otherwise serial numbers
  std::string bodyId, headId; // serial numbers; empty: unknown
};

/// Whether both have the same body, by serial number if both are known, otherwise by name.
bool isSameRobot(const RunRobot& a, const RunRobot& b);

/// A run's estimate of a joint's offset: encoder reading minus true angle.
struct RunOffset {
  double value = 0;     // [rad]
  double sigma = 0;     // standard deviation, widened by the misfit as in the result [rad]
  double freedom = 1e6; // degrees of freedom of its t distribution, above 4
};

/// What became of the numbers of a run.
enum class RunOutcome {
  kept,      // set on the robot or written into its configuration
  unneeded,  // the robot was well calibrated before and kept what it had
  takenBack, // the error did not fall by half, so the robot kept what it had
};

inline constexpr std::string_view applyKind = "apply", undoKind = "undo", fallKind = "fall";

/// One run: a calibration on the robot (`kind`: "head", "left leg", ..), a result that was applied (`applyKind`), or an
/// event of the robot: `undoKind`, `fallKind`.
struct Run {
  std::string id; // name of its file without .json; letters, digits, ".", "-" and "_"
  RunTime time;
  RunRobot robot;
  std::string kind;
  std::string by;                                // the program that made it
  std::optional<RunOutcome> outcome;             // absent: an event
  std::optional<double> errorBefore, errorAfter; // rms distance of corners from their prediction [px]
  bool heldOut = false;                          // those corners were not used for the calibration
  std::string captures, result;                  // folder and file, where it ran; empty: none
  std::string sha256;                            // of the (first) captures.json that was solved; empty: unknown
  std::map<std::string, RunOffset> offsets;      // by joint; those that the captures determine
  std::map<std::string, double> set;             // offsets that the configuration had after the run, by joint [rad]
  std::string undoes;                            // id of the run that an undo took back; empty: unknown

  bool isEvent() const { return !outcome; }
};

/// An id for a new run: "2026-02-14_10-05-00_nao21_left-leg".
std::string makeRunId(const Run& run);

/// "2026-02-14T10:05:00Z"
std::string formatTime(RunTime time);
/// "2026-02-14 10:05"
std::string formatMinute(RunTime time);
/// "2026-02-14"
std::string formatDay(RunTime time);
/// Parses "2026-02-14T10:05:00Z", also with a blank instead of T, without Z, seconds or time of day. Absent for
/// anything else.
std::optional<RunTime> parseTime(const std::string& text);

/// The present time of this computer.
RunTime presentTime();

} // namespace naocal
