#include "diagnosis/CheckedCalibration.hpp"

#include "diagnosis/DiagnosisWording.hpp"
#include "diagnosis/Findings.hpp"
#include "diagnosis/anomalies/DataChecks.hpp"
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
    std::vector<Finding> findings = listAnomalies(suspect(found), measurements);
    throw WrongSetUpError{std::move(found), std::move(findings)};
  }
}

/// Accidents that explain what the model leaves.
std::vector<DataAnomaly> explainByAccidents(const FittedModel& fitted, const CandidateTests& tests,
                                            const Measurements& given) {
  try {
    return findAccidents(fitted, tests, given);
  } catch (const InputError&) { // with all at full weight a corner lies behind its camera
    return {};
  }
}

/// What is suspicious in the place of the verdict on a fit that it spoiled. Of a fit to a wrong set-up nothing holds.
void suspectFirst(const Measurements& measurements, CalibrationResult& result) {
  std::vector<Finding> findings = listAnomalies(result.suspicious, measurements);
  if (result.setUps.empty()) {
    appendNew(furtherThanVerdict(result.findings, measurements), findings);
  }
  result.sentence = findings.front().sentence;
  result.findings = std::move(findings);
}

} // namespace

CalibrationResult calibrateChecked(const Measurements& measurements, const Model& model,
                                   const CalibrationOptions& options) {
  auto [result, weighed, tests] = calibrateOrSuspect(measurements, model, options);
  result.setUps = findSetUps({measurements, model, result});
  if (result.setUps.empty()) {
    result.setUps = findSlippedCounts({measurements, model, result});
  }
  if (!result.setUps.empty()) {
    result.suspicious = suspect(result.setUps);
  } else if (tests && (result.verdict != ResultVerdict::good || measurements.hasUnknownNoise())) {
    // accidents raise noise that is estimated, until the result looks good
    result.suspicious = explainByAccidents({weighed ? *weighed : measurements, model, result}, *tests, measurements);
  }
  if (!result.suspicious.empty()) {
    result.verdict = ResultVerdict::doNotUse;
    result.usable = false;
    suspectFirst(measurements, result);
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
