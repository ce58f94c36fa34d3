#pragma once

#include "diagnosis/Diagnosis.hpp"

#include <vector>

namespace naocal {

/// Mistakes of the set-up as suspicions.
std::vector<DataAnomaly> suspect(const std::vector<WrongSetUp>& setUps);

/// Finds mistakes of the set-up (`findSetUps`) and accidents: a displaced board or robot, a bad capture. Reports one
/// only if it explains the captures far better than any effect. `given`: the measurements at full weight.
std::vector<DataAnomaly> findAnomalies(const FittedModel& fitted, const CandidateTests& candidateTests,
                                       const Measurements& given);

/// The accidents alone: something that was moved far, or an event.
std::vector<DataAnomaly> findAccidents(const FittedModel& fitted, const CandidateTests& candidateTests,
                                       const Measurements& given);

/// Why no fit of this model is possible: a mistake of the set-up, or a robot or board that was moved far.
std::vector<DataAnomaly> findGrossAnomalies(const Measurements& measurements, const Model& model);

/// Zeros that are off by whole motor turns (`findSlippedCounts`).
std::vector<DataAnomaly> findSlips(const FittedModel& fitted);

/// Only one-off events, which the misfit of an effect may have masked before it was added.
std::vector<DataAnomaly> findTransientAnomalies(const FittedModel& fitted, const CandidateTests& candidateTests,
                                                const Measurements& given);

/// Observations with mostly outlying corners.
std::vector<DataAnomaly> findDisplacedBoards(const Measurements& measurements, const CalibrationResult& fit);

} // namespace naocal
