#pragma once

#include "calibration/Calibration.hpp"
#include "calibration/result/ResultFile.hpp"
#include "diagnosis/Diagnosis.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// naocal as a library: read captures, calibrate, diagnose, write.
///
/// Link `naocal::naocal` (find_package(naocal)). Wrong input (files, labels) throws InputError, whose what() is one
/// sentence: where, what was expected, what was found, what to do. All functions are thread-safe.
namespace naocal {

/// Capture sets of one robot, and their measurements (with the sets as recorded).
struct Captures {
  ResultSources sources; // folders and SHA-256 of their captures.json
  Measurements measurements;
  std::vector<std::string> skipped = {}; // one sentence per capture that was left out (`ReadOptions::skipBad`)
};

struct ReadOptions {
  bool samePlace = false; // boards and stances of equal id have the same placement in all sets
  bool skipBad = false;   // leaves out captures that cannot be used instead of refusing their set
};

/// Reads folders with a captures.json each. `configuration` holds the robots' descriptions (`drawings/`). Throws
/// InputError for an empty list.
Captures readCaptures(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& configuration,
                      const ReadOptions& options = {});

#ifdef NAOCAL_INSTALLED_CONFIGURATION
/// The same with the installed robot descriptions.
inline Captures readCaptures(const std::vector<std::filesystem::path>& folders) {
  return readCaptures(folders, NAOCAL_INSTALLED_CONFIGURATION);
}
#endif

/// A model and the estimates of its unknowns.
struct Calibrated {
  Model model;
  CalibrationResult result; // verdict, sentence, estimates with their intervals
};

/// Calibrates the base model (joint offsets, camera rotations) with further effects, such as "elasticity@LKneePitch".
Calibrated calibrate(const Captures& captures, const std::vector<std::string>& effects = {},
                     const CalibrationOptions& options = {});

/// Tests which physical effects that model lacks.
Diagnosis diagnose(const Captures& captures, const std::vector<std::string>& effects = {});

/// Writes RESULT.json atomically.
void writeResult(const Captures& captures, const Calibrated& calibrated, const std::filesystem::path& file);

/// Writes DIAGNOSIS.json atomically.
void writeDiagnosis(const Diagnosis& diagnosis, const std::filesystem::path& file);

} // namespace naocal
