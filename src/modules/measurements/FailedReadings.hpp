#pragma once

#include "data/Capture.hpp"
#include "robot/Robot.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace naocal {

/// Readings of one target by one tracker that are none: what a tracker writes while it does not see its target.
struct FailedReadings {
  enum class Kind {
    origin, // the position is exactly 0, 0, 0
    frozen  // an earlier reading once more, equal in every digit, although the target moved
  };
  Kind kind = Kind::origin;
  std::string tracker, target;       // ids; the target is a marker or a frame
  std::vector<std::size_t> captures; // indices within the set, ascending
  std::size_t all = 0;               // readings of this target by this tracker
};

/// Finds them where what is drawn of the robot says that the target was elsewhere. A robot may reach its tracker's
/// origin, as where the tracker was set to zero at the first pose. So readings at 0, 0, 0 are none where
///   - the target moved between two of them, or
///   - their distances from the other readings, which no placement of the tracker changes, differ from the distances of
///     the target's places by three times as much as those of the other readings do.
/// Where a value comes back after other ones, it stands for "nothing", and its first occurrence is none either. Looks
/// at captures with a `source` only: planned ones hold no readings yet.
std::vector<FailedReadings> findFailedReadings(const CaptureSet& set, const Robot& robot);

/// Removes these readings from their captures, which stay, even if nothing is left in them.
void removeFailedReadings(const std::vector<FailedReadings>& failed, CaptureSet& set);

/// "4 of 40 readings of marker by tracker are exactly 0, 0, 0: taken as no reading and left out: captures 5, 17, 23,
/// 31". `where`: "captures 5, 17, 23, 31".
std::string describeFailedReadings(const FailedReadings& failed, const std::string& where);

/// The same with the ids of the captures of the set.
std::string describeFailedReadings(const FailedReadings& failed, const CaptureSet& set);

} // namespace naocal
