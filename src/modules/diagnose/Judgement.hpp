#pragma once

#include "diagnose/Diagnosis.hpp"

#include <string>
#include <vector>

namespace naocal {

/// The last word on each candidate when the ladder ends, best first: its state, what the captures could have noticed of
/// it, and which others they cannot tell from it. `last`: the question to the last `model` and its `fit`; `suggested`:
/// labels in the order in which they were added.
std::vector<CandidateFinding> judged(std::vector<CandidateFinding> findings, const Inquiry& last, const Model& model,
                                     const CalibrationResult& fit, const std::vector<std::string>& suggested);

} // namespace naocal
