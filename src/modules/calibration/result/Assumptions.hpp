#pragma once

#include "calibration/result/CalibrationResult.hpp"

#include <string>
#include <vector>

namespace naocal {

/// Whether a term depends on directions of approach that were not recorded but taken from the order of captures.
bool reliesOnOrder(const Measurements& measurements, const Term& term);

/// What was taken for granted about the captures, a sentence each: readings of trackers that were left out as none,
/// and, if one of `terms` depends on them, directions of approach that the order of captures tells.
std::vector<std::string> describeAssumptions(const Measurements& measurements, const std::vector<Term>& terms);

/// Warnings of boards that were displaced in single pictures, and left out there.
std::vector<std::string> describeDisplacedBoards(const Measurements& measurements, const CalibrationResult& result);

} // namespace naocal
