#pragma once

#include "calibration/CandidateTests.hpp"
#include "diagnosis/DiagnosisResult.hpp"

#include <string>
#include <vector>

namespace naocal {

/// The finding of the candidate with this label; null without it.
CandidateFinding* findFinding(std::vector<CandidateFinding>& findings, const std::string& label);

/// Final assessment of each candidate, best first: state, detection power, and equivalent candidates. `last`: tests of
/// the last `model` at its `fit`; `suggested`: labels in order of addition.
std::vector<CandidateFinding> judgeCandidates(std::vector<CandidateFinding> findings, const CandidateTests& last,
                                              const Model& model, const CalibrationResult& fit,
                                              const std::vector<std::string>& suggested);

} // namespace naocal
