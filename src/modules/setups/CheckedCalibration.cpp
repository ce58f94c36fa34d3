#include "setups/CheckedCalibration.hpp"

#include "setups/SetUpSearch.hpp"

#include <fmt/format.h>

namespace naocal {

namespace {

CalibrationResult calibrateOrSuspect(const Measurements& measurements, const Model& model,
                                     const CalibrationOptions& options) {
  try {
    return calibrate(measurements, model, options);
  } catch (const InputError&) {
    std::vector<WrongSetUp> found = findSetUps(measurements, model);
    if (found.empty()) {
      throw;
    }
    throw WrongSetUpError{formatWrongSetUps(found), std::move(found)};
  }
}

} // namespace

CalibrationResult calibrateChecked(const Measurements& measurements, const Model& model,
                                   const CalibrationOptions& options) {
  CalibrationResult result = calibrateOrSuspect(measurements, model, options);
  result.setUps = findSetUps({measurements, model, result});
  if (result.setUps.empty()) {
    result.setUps = findSlippedCounts({measurements, model, result});
  }
  if (!result.setUps.empty()) {
    result.verdict = ResultVerdict::doNotUse;
    result.usable = false;
    result.sentence = formatWrongSetUps(result.setUps);
  }
  return result;
}

std::vector<std::string> labelsOf(const std::vector<WrongSetUp>& found) {
  std::vector<std::string> labels;
  for (const WrongSetUp& setUp : found) {
    labels.push_back(setUp.label);
  }
  return labels;
}

std::string formatWrongSetUps(const std::vector<WrongSetUp>& found) {
  return fmt::format("Something is wrong with the captures or the set-up: {}.", describeSetUps(found));
}

} // namespace naocal
