#pragma once

#include "diagnosis/DiagnosisResult.hpp"

namespace naocal {

/// A model, its fit, and its candidate tests.
struct DiagnosedModel {
  FittedModel fitted;
  const CandidateTests& candidateTests;
};

/// Adds the figures to a finished diagnosis: captures per pose, correlations of the first candidates, their signatures,
/// and the residuals of both models. `given`: the model as given; `last`: the model with all suggestions.
void assembleFigures(const DiagnosedModel& given, const DiagnosedModel& last, Diagnosis& diagnosis);

/// Adds the partial residuals of an effect that is certain, but too small to matter. `with`: the model with it.
void addNegligibleCause(const FittedModel& with, const Term& effect, Diagnosis& diagnosis);

/// Adds the partial residuals of the first of `driverCurves`, before those of named effects; nothing where these are
/// not a joint's.
void addUnnamedCause(const DiagnosedModel& last, Diagnosis& diagnosis);

} // namespace naocal
