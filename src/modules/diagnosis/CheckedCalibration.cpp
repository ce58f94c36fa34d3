#include "diagnosis/CheckedCalibration.hpp"

#include "diagnosis/DiagnosisWording.hpp"
#include "diagnosis/anomalies/DataChecks.hpp"
#include "diagnosis/evidence/CandidateTests.hpp"
#include "estimation/CandidateTerms.hpp"
#include "setups/SetUpSearch.hpp"

namespace naocal {

namespace {

WeighedCalibration calibrateOrSuspect(const Measurements& measurements, const Model& model,
                                      const CalibrationOptions& options) {
  try {
    return calibrateWeighing(measurements, model, options);
  } catch (const InputError&) {
    std::vector<WrongSetUp> found = findSetUps(measurements, model);
    if (found.empty()) {
      throw;
    }
    throw WrongSetUpError{formatAnomalies(suspect(found)), std::move(found)};
  }
}

/// Accidents that explain what the model leaves.
std::vector<DataAnomaly> explainByAccidents(const FittedModel& fitted, const Measurements& given,
                                            const CalibrationOptions& options) {
  if (fitted.fit.verdict == ResultVerdict::good || !options.testMissingEffects) {
    return {};
  }
  try {
    const std::vector<Term> candidates = testableTerms(fitted.measurements, fitted.model, options.effects);
    return findAccidents(fitted, {fitted, candidates, {.draws = 0}}, given);
  } catch (const InputError&) { // no linearisation at this fit
    return {};
  }
}

} // namespace

CalibrationResult calibrateChecked(const Measurements& measurements, const Model& model,
                                   const CalibrationOptions& options) {
  auto [result, weighed] = calibrateOrSuspect(measurements, model, options);
  result.setUps = findSetUps({measurements, model, result});
  if (result.setUps.empty()) {
    result.setUps = findSlippedCounts({measurements, model, result});
  }
  result.suspicious = result.setUps.empty() ? explainByAccidents({weighed ? *weighed : measurements, model, result},
                                                                 measurements, options)
                                            : suspect(result.setUps);
  if (!result.suspicious.empty()) {
    result.verdict = ResultVerdict::doNotUse;
    result.usable = false;
    result.sentence = formatAnomalies(result.suspicious);
    result.reasons.insert(result.reasons.begin(), describeAnomalies(result.suspicious));
  }
  return std::move(result);
}

std::vector<std::string> labelsOf(const std::vector<WrongSetUp>& found) {
  std::vector<std::string> labels;
  for (const WrongSetUp& setUp : found) {
    labels.push_back(setUp.label);
  }
  return labels;
}

} // namespace naocal
