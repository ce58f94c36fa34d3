#pragma once

#include "calibrate/ShownOffsets.hpp"

#include <string>
#include <vector>

namespace naocal {

/// The gap of each measured joint's gear, as effects to add to a model: load holds it at one end, and where friction
/// carries the load the joint lags behind its last motion. Empty where the robot stood on both feet: there the loads of
/// the joints are not known.
std::vector<std::string> gearGaps(const Measurements& measurements);

} // namespace naocal
