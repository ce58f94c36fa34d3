#pragma once

#include "diagnosis/Diagnosis.hpp"
#include "diagnosis/Events.hpp"

#include <vector>

namespace naocal {

/// What looks like an accident or a wrong set-up rather than physics: a board that was kicked or a robot that slipped
/// at some moment, one bad capture, a board of another size, a joint of swapped sign, cameras of swapped names. Named
/// only where that explains far more than any effect does.
std::vector<DataAnomaly> findAnomalies(const FittedModel& fitted, const CandidateTests& inquiry);

/// Of these only what happened once: an effect that was added may have hidden it.
std::vector<DataAnomaly> findTransientAnomalies(const FittedModel& fitted, const CandidateTests& inquiry);

/// Sightings most of whose corners fit nothing.
std::vector<DataAnomaly> findDisplacedBoards(const Measurements& measurements, const CalibrationResult& fit);

/// Approaches and whole poses whose angles may be wrong, as candidates: somebody touched the robot, a joint gave way.
/// Between floor and head the robot is then moved as one body, for both cameras. Only the few whose corners lie
/// farthest from their predictions together; of those that saw boards on the floor.
std::vector<TransientEvent> enumerateWrongAngles(const Measurements& measurements, const CalibrationResult& fit);

} // namespace naocal
