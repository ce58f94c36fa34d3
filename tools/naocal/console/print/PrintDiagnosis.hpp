#pragma once

#include "console/CommandLine.hpp"
#include "diagnosis/Diagnosis.hpp"
#include "poses/NextPoses.hpp"

#include <string>

namespace naocal {

/// Prints a diagnosis: verdict, model revisions, candidates with bars, curves, and the command that adds the
/// suggestion.
void printDiagnosis(const Diagnosis& diagnosis, const GivenOptions& asked);

/// Prints how to use an unexplained curve: how to write it as a custom effect, or how to continue with the model file
/// `file` that holds it. `isThere`: an expression fits the curve.
void printOwnEffectHint(bool isThere, const Diagnosis& diagnosis, const GivenOptions& asked, const std::string& file);

/// Candidates that are printed unless asked for more: a screen holds them beside the rest.
inline constexpr std::size_t candidateRows = 8;

/// Prints the first `rows` candidates only; `areNumbered`: with the numbers of their rows.
void printCandidates(const Diagnosis& diagnosis, std::size_t rows = candidateRows, bool areNumbered = false);

/// Prints everything known about one candidate.
void printCandidate(const CandidateFinding& finding, const Diagnosis& diagnosis);

/// Prints the open questions and the command that proposes poses, or, if poses were written to `file`, their benefit.
void printNextPoses(const NextPoses& next, GivenOptions asked, const std::string& file);

} // namespace naocal
