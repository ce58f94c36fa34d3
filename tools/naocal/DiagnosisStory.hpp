#pragma once

#include "AsAsked.hpp"

#include "diagnosis/Diagnosis.hpp"

namespace naocal {

/// Tells a diagnosis to a person: verdict, ladder, candidates with bars, curves, and the command that adds the first.
void printDiagnosis(const Diagnosis& diagnosis, const AsAsked& asked);

/// What to do with a curve beyond the catalogue: have it written as an effect of one's own, or go on with the model
/// file `file` that holds it. `isThere`: there is one that an expression follows.
void printOwn(bool isThere, const Diagnosis& diagnosis, const AsAsked& asked, const std::string& file);

/// Its candidates alone.
void printCandidates(const Diagnosis& diagnosis);

} // namespace naocal
