#pragma once

#include "calibration/Calibration.hpp"

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace naocal {

/// Where a result came from.
struct ResultSources {
  std::vector<std::string> sets;   // folders
  std::vector<std::string> sha256; // of their captures.json

  /// Adds a capture set's folder, named so that it is found from anywhere. Throws InputError where it holds no
  /// captures.json.
  void add(const std::filesystem::path& folder);
};

/// RESULT.json: estimates with their uncertainty, what was assumed, and every corner's prediction for reports.
nlohmann::json resultJson(const FittedModel& fitted, const ResultSources& inputs);

/// What a result file says about robot and scene, without its uncertainty.
struct StoredResult {
  std::vector<std::string> terms;           // "jointOffset@LKneePitch"
  std::map<std::string, double> values;     // "jointOffset@LKneePitch.o" -> value [the unknown's unit]
  std::map<std::string, Placement> boards;  // by name
  std::map<std::string, Placement> stances; // by name
  std::string definitions = "[]";           // the person's own effects among them: a list of JSON
  Noise noise;                              // that it was found with
  bool usable = false;
};

/// Reads a result file. Throws InputError with file, place, what was expected and found.
StoredResult readResult(const std::filesystem::path& file);

} // namespace naocal
