#include "diagnosis/DiagnosisFigures.hpp"

#include "inference/DriverBasis.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace naocal {

namespace {

Figures::Left buildResidualViews(const DiagnosedModel& diagnosed) {
  const FittedModel& fitted = diagnosed.fitted;
  return {computeJointCorrections(fitted.measurements, diagnosed.candidateTests), computeResidualField(fitted),
          estimateBoardShapes(fitted), recordReadings(fitted), readingLevels(fitted.measurements, fitted.fit.noise)};
}

/// Adds the partial residuals of the suggested effects of the catalogue.
void addCauses(const DiagnosedModel& last, Diagnosis& diagnosis) {
  Figures& figures = diagnosis.figures;
  const ExplainedModel explained{last.fitted, last.candidateTests, figures.last.whatIfs};
  for (const std::string& label : diagnosis.suggested) {
    const Term* const term = last.fitted.model.find(label);
    auto cause = term ? computePartialResidual(explained, *term, figures.recorded) : std::nullopt;
    if (cause) {
      figures.causes.push_back(std::move(*cause));
    }
  }
}

std::vector<std::string> labelsOf(const std::vector<CandidateFinding>& ranking) {
  std::vector<std::string> result;
  for (const CandidateFinding& finding : ranking) {
    result.push_back(finding.term.label());
  }
  return result;
}

/// Adds the signatures of the first few candidates that were tested against `given`.
void addSignatures(const DiagnosedModel& given, std::vector<CandidateFinding>& ranking) {
  constexpr std::size_t shown = 10;
  std::vector<std::size_t> candidates;
  std::vector<CandidateFinding*> findings;
  for (CandidateFinding& finding : ranking) {
    const auto candidate = given.candidateTests.findCandidate(finding.term.label());
    if (candidate && candidates.size() < shown) {
      candidates.push_back(*candidate);
      findings.push_back(&finding);
    }
  }
  std::vector<EffectSignature> signatures = computeSignatures(given.fitted, given.candidateTests, candidates);
  for (std::size_t i = 0; i < signatures.size(); ++i) {
    findings[i]->imprint = std::move(signatures[i]);
  }
}

} // namespace

void assembleFigures(const DiagnosedModel& given, const DiagnosedModel& last, Diagnosis& diagnosis) {
  constexpr std::size_t compared = 12;
  const FittedModel& fitted = given.fitted;
  diagnosis.figures.taken = indexCaptures(fitted.measurements);
  diagnosis.figures.aliases = computeAliasMatrix(given.candidateTests, labelsOf(diagnosis.ranking), compared);
  addSignatures(given, diagnosis.ranking);
  diagnosis.figures.recorded = collectDrivers(fitted.measurements, fitted.model, fitted.fit.unknowns);
  diagnosis.figures.given = buildResidualViews(given);
  if (!diagnosis.suggested.empty()) {
    diagnosis.figures.last = buildResidualViews(last);
    addCauses(last, diagnosis);
  }
}

void addNegligibleCause(const FittedModel& with, const Term& effect, Diagnosis& diagnosis) {
  const CandidateTests tests{with, {}, {.draws = 0, .map = false}};
  const std::vector<SingleJointCorrection> left = computeJointCorrections(with.measurements, tests);
  if (auto cause = computePartialResidual({with, tests, left}, effect, diagnosis.figures.recorded)) {
    diagnosis.figures.causes.push_back(std::move(*cause));
  }
}

void addUnnamedCause(const DiagnosedModel& last, Diagnosis& diagnosis) {
  Figures& figures = diagnosis.figures;
  const Figures::Left& left = diagnosis.suggested.empty() ? figures.given : figures.last; // of the last model
  if (auto cause = computePartialResidual({last.fitted, last.candidateTests, left.whatIfs},
                                          diagnosis.driverCurves.front(), figures.recorded)) {
    figures.causes.push_back(std::move(*cause)); // named ones are told first
  }
}

} // namespace naocal
