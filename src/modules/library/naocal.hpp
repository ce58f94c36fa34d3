#pragma once

#include "calibration/Calibration.hpp"
#include "calibration/ResultFile.hpp"
#include "diagnosis/Diagnosis.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// naocal as a library: read captures, calibrate, diagnose, write.
///
/// Link `naocal::naocal` (find_package(naocal)). Everything that a person gave wrongly (files, labels) is refused with
/// an InputError, whose what() is one sentence: where, what was expected, what was found, what to do. All functions may
/// be called by several threads at once.
namespace naocal {

/// Capture sets of one robot, and their measurements (with the sets as recorded).
struct Captures {
  ResultSources sources; // folders and SHA-256 of their captures.json
  Measurements measurements;
};

/// Reads folders with a captures.json each. `configuration` holds the robots' descriptions (`drawings/`).
Captures readCaptures(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& configuration);

#ifdef NAOCAL_INSTALLED_CONFIGURATION
/// The same with the robots' descriptions that were installed beside the library.
inline Captures readCaptures(const std::vector<std::filesystem::path>& folders) {
  return readCaptures(folders, NAOCAL_INSTALLED_CONFIGURATION);
}
#endif

/// A model and what the captures say of its unknowns.
struct Calibrated {
  Model model;
  CalibrationResult result; // verdict, sentence, estimates with their intervals
};

/// Calibrates the base model (joint offsets, camera rotations) with further effects, such as "elasticity@LKneePitch".
Calibrated calibrate(const Captures& captures, const std::vector<std::string>& effects = {},
                     const CalibrationOptions& options = {});

/// Asks which physical effect is missing in that model.
Diagnosis diagnose(const Captures& captures, const std::vector<std::string>& effects = {});

/// Writes RESULT.json, whole or not at all.
void writeResult(const Captures& captures, const Calibrated& calibrated, const std::filesystem::path& file);

/// Writes DIAGNOSIS.json, whole or not at all.
void writeDiagnosis(const Diagnosis& diagnosis, const std::filesystem::path& file);

} // namespace naocal
