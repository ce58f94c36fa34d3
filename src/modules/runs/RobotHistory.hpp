#pragma once

#include "runs/OffsetJumps.hpp"
#include "runs/Run.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// A run within its robot's history.
struct HistoricRun {
  Run run;
  std::optional<RunTime> undone; // when its numbers were taken back; they had been kept

  /// Whether its offsets are compared with other runs': kept or found unneeded, and not undone. Numbers that were taken
  /// back did not predict the check's pictures.
  bool isCompared() const;
};

/// A run's estimate of a joint's offset.
struct HistoricOffset {
  std::size_t run = 0; // index of the run
  RunOffset offset;
  std::optional<std::size_t> since;   // the compared run before it that has this joint
  std::optional<OffsetChange> change; // since that run
  bool afterFall = false;             // a fall was recorded between the two
};

/// The runs of one robot, by time.
struct RobotHistory {
  RunRobot robot;                // as the newest run names it
  std::vector<HistoricRun> runs; // calibrations, and undos of something that is not among them
  std::vector<RunTime> falls;
  std::map<std::string, std::vector<HistoricOffset>> joints; // by joint
};

/// Groups runs by robot: equal serial numbers of the body, otherwise equal names. Each robot's runs are compared: all
/// joints of a run with the latest compared run before it that has the joint (`findJumps`).
std::vector<RobotHistory> makeHistories(const std::vector<Run>& runs);

/// The robot of this name or serial number of body or head. Throws InputError that lists the known ones.
const RobotHistory& findRobot(const std::vector<RobotHistory>& histories, const std::string& name);

/// The last run of the robot that set these offsets [rad] and was not undone since: the one that an undo takes back.
/// Absent if there is none.
std::optional<std::string> findRunOf(const std::map<std::string, double>& set, const RunRobot& robot,
                                     const std::vector<Run>& runs);

} // namespace naocal
