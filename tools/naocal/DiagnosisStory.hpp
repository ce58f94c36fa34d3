#pragma once

#include "diagnose/Diagnosis.hpp"

#include <string>
#include <vector>

namespace naocal {

/// Tells a diagnosis to a person: verdict, ladder, candidates with bars, curves, and the command that adds the first.
void printDiagnosis(const Diagnosis& diagnosis, const std::vector<std::string>& sets);

/// Its candidates alone.
void printCandidates(const Diagnosis& diagnosis);

} // namespace naocal
