#pragma once

#include "diagnosis/Diagnosis.hpp"

#include <string>

namespace naocal {

/// "effect-missing", ... as in diagnosis files.
std::string toString(Verdict verdict);
/// "present", ..., "no-data".
std::string toString(CandidateState state);
/// The state as people read it: "needed", "could explain", "ruled out", ...
std::string describeState(CandidateState state);

/// The diagnosis in a sentence or two for people.
std::string summarize(const Diagnosis& diagnosis);

/// How far a curve deflects: "±0.30°".
std::string formatAmplitude(const DriverCurve& curve);

/// Whether captures tell an unknown of a finding at all: to ten of its plausible sizes.
bool isTold(const CandidateFinding& finding, std::size_t unknown);

/// "c = 0.34 ± 0.02°/Nm, t undetermined": a finding's sizes.
std::string formatSizes(const CandidateFinding& finding);

} // namespace naocal
