#pragma once

#include "calibration/result/Finding.hpp"
#include "estimation/Model.hpp"

#include <vector>

namespace naocal {

/// Whether a term depends on directions of approach that were not recorded but taken from the order of captures.
bool reliesOnOrder(const Measurements& measurements, const Term& term);

/// What was taken for granted about the captures: readings of trackers that were left out as none, and, if one of
/// `terms` depends on them, directions of approach that the order of captures tells.
std::vector<Finding> listAssumptions(const Measurements& measurements, const std::vector<Term>& terms);

} // namespace naocal
