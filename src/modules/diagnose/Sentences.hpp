#pragma once

#include "diagnose/Diagnosis.hpp"

#include <string>

namespace naocal {

/// "effect-missing", ... as in diagnosis files.
std::string nameOf(Verdict verdict);
/// "present", ..., "no-data".
std::string nameOf(State state);

/// The diagnosis in a sentence or two for people.
std::string sentence(const Diagnosis& diagnosis);

/// "c = 0.0060 ± 0.0003 rad/Nm": a finding's sizes; angles in degrees too.
std::string sizes(const CandidateFinding& finding);

} // namespace naocal
