#include "library/naocal.hpp"

#include "data/CaptureSetFile.hpp"
#include "diagnosis/CheckedCalibration.hpp"
#include "diagnosis/DiagnosisFile.hpp"
#include "estimation/ModelBuilder.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "robot/RobotOfSet.hpp"

#include <nlohmann/json.hpp>
#include <utility>

namespace naocal {

Captures readCaptures(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& configuration,
                      const ReadOptions& options) {
  if (folders.empty()) {
    throw InputError{"expected at least one folder with captures.json, found none"};
  }
  Captures captures;
  std::vector<CaptureSet> sets;
  for (const std::filesystem::path& folder : folders) {
    LoadedCaptureSet read = readCaptureSet(folder, options.skipBad ? BadCapturePolicy::skip : BadCapturePolicy::refuse);
    captures.skipped.insert(captures.skipped.end(), read.skipped.begin(), read.skipped.end());
    captures.sources.add(folder);
    sets.push_back(std::move(read.set));
  }
  const Robot robot = loadRobot(sets, configuration);
  captures.measurements = buildMeasurements(std::move(sets), robot, options.samePlace);
  return captures;
}

Calibrated calibrate(const Captures& captures, const std::vector<std::string>& effects,
                     const CalibrationOptions& options) {
  Model model = buildModel(captures.measurements, effects);
  CalibrationResult result = calibrateChecked(captures.measurements, model, options);
  return {std::move(model), std::move(result)};
}

Diagnosis diagnose(const Captures& captures, const std::vector<std::string>& effects) {
  DiagnosisOptions options;
  options.with = effects;
  return diagnose(captures.measurements, options);
}

void writeResult(const Captures& captures, const Calibrated& calibrated, const std::filesystem::path& file) {
  const auto& [model, result] = calibrated;
  writeAtomically(file, resultJson({captures.measurements, model, result}, captures.sources).dump(1) + "\n");
}

void writeDiagnosis(const Diagnosis& diagnosis, const std::filesystem::path& file) {
  writeAtomically(file, diagnosisJson(diagnosis).dump(1) + "\n");
}

} // namespace naocal
