#pragma once

#include "runs/RobotHistory.hpp"

#include <string>

namespace naocal {

/// Prints a robot's history: the sentence, then its runs and falls as a table by time.
void printHistory(const RobotHistory& history);

/// Prints the offset of one joint over time: the sentence, then each estimate with its error bar, and the change since
/// the one before. Throws InputError if no run has the joint.
void printJointHistory(const RobotHistory& history, const std::string& joint);

} // namespace naocal
