#pragma once

#include "diagnose/Events.hpp"

#include <vector>

namespace naocal {

/// Approaches and whole poses whose angles may be wrong, as candidates: somebody touched the robot, a joint gave way.
/// Between floor and head the robot is then moved as one body, for both cameras. Only the few whose corners lie
/// farthest from their predictions together; of those that saw boards on the floor.
std::vector<Event> wrongAngles(const std::vector<CaptureSet>& sets, const Measurements& measurements,
                               const CalibrationResult& fit);

} // namespace naocal
