#pragma once

#include "console/CommandLine.hpp"
#include "diagnosis/Diagnosis.hpp"
#include "poses/NextPoses.hpp"

#include <string>

namespace naocal {

/// Tells a diagnosis to a person: verdict, ladder, candidates with bars, curves, and the command that adds the first.
void printDiagnosis(const Diagnosis& diagnosis, const GivenOptions& asked);

/// What to do with a curve beyond the catalogue: have it written as an effect of one's own, or go on with the model
/// file `file` that holds it. `isThere`: there is one that an expression follows.
void printOwnEffectHint(bool isThere, const Diagnosis& diagnosis, const GivenOptions& asked, const std::string& file);

/// Its candidates alone.
void printCandidates(const Diagnosis& diagnosis);

/// Tells what a diagnosis leaves open and the command that proposes poses; or, where they were written to `file`, what
/// they are worth.
void printNextPoses(const NextPoses& next, GivenOptions asked, const std::string& file);

} // namespace naocal
