#pragma once

#include "runs/RobotHistory.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace naocal {

/// Sentences and words about runs, the same on all surfaces. Angles in degrees.

/// "nao21", or "nao21 with head nao07".
std::string describeRobot(const RunRobot& robot);

/// "kept", "kept, then undone", "not needed", "taken back", "undo".
std::string describeOutcome(const HistoricRun& run);

/// "16.2 -> 2.0 px", with an asterisk if the corners were used for the calibration; "-" if unknown.
std::string describeErrors(const Run& run);

/// "+2.31° ± 0.08°": two digits of sigma.
std::string formatChange(const OffsetChange& change);

/// A robot's runs and jumps in one sentence or two.
std::string describeHistory(const RobotHistory& history);

/// The history of one joint's offset in one sentence or two. Throws InputError if no run has the joint.
std::string describeJoint(const RobotHistory& history, const std::string& joint);

/// "after LKneePitch jumped by ...": one clause per jump, by time: "LKneePitch by +2.31° ± 0.08° between 2026-03-01 and
/// 2026-03-08, with a fall in between".
std::vector<std::string> describeJumps(const RobotHistory& history);

/// How a jump is judged, in one sentence.
std::string describeRule();

} // namespace naocal
