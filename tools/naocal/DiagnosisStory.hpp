#pragma once

#include "AsAsked.hpp"

#include "diagnose/Diagnosis.hpp"

namespace naocal {

/// Tells a diagnosis to a person: verdict, ladder, candidates with bars, curves, and the command that adds the first.
void printDiagnosis(const Diagnosis& diagnosis, const AsAsked& asked);

/// Its candidates alone.
void printCandidates(const Diagnosis& diagnosis);

} // namespace naocal
