#pragma once

#include "diagnosis/anomalies/Events.hpp"

#include <vector>

namespace naocal {

/// Candidates for wrong joint angles during a whole approach or pose (somebody touched the robot, a joint gave way):
/// the robot between floor and head moves as a rigid body, for both cameras alike. Only the few with the largest common
/// error of their corners, among those that saw boards on the floor, or of their other readings: a bad one looks the
/// same.
std::vector<TransientEvent> enumerateWrongAngles(const FittedModel& fitted);

} // namespace naocal
