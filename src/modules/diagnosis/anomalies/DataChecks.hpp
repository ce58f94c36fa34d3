#pragma once

#include "diagnosis/Diagnosis.hpp"

#include <vector>

namespace naocal {

/// Finds accidents and set-up errors: a displaced board or robot, a bad capture, a wrong board size, a joint of
/// inverted sign, swapped camera names. Reports one only if it explains the captures far better than any effect.
/// `given`: the measurements at full weight.
std::vector<DataAnomaly> findAnomalies(const FittedModel& fitted, const CandidateTests& candidateTests,
                                       const Measurements& given);

/// Only one-off events, which the misfit of an effect may have masked before it was added.
std::vector<DataAnomaly> findTransientAnomalies(const FittedModel& fitted, const CandidateTests& candidateTests,
                                                const Measurements& given);

/// Observations with mostly outlying corners.
std::vector<DataAnomaly> findDisplacedBoards(const Measurements& measurements, const CalibrationResult& fit);

} // namespace naocal
