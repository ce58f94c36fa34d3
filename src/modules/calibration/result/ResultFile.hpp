#pragma once

#include "calibration/Calibration.hpp"
#include "calibration/result/PlacementFile.hpp"

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace naocal {

/// Input files of a result.
struct ResultSources {
  std::vector<std::string> sets;        // folders; in a file relative to its own folder where they lie near it
  std::vector<std::string> sha256;      // of each set's captures.json
  std::vector<std::string> names = {};  // of the sets when they were read; empty: those of the folders
  std::vector<std::string> setUps = {}; // wrong set-ups that were mended before the fit: "reversedJoint@elbow"

  /// Adds a capture set's folder as an absolute path. Throws InputError if it contains no captures.json.
  void add(const std::filesystem::path& folder);

  /// The same as a file should name them (`placeFrom`); unchanged for "-" and "".
  ResultSources placedBeside(const std::filesystem::path& file) const;
};
/// {"sets": [folders], "sha256": [..], "names": [..], "setUps": [..]}, the last where there are some
nlohmann::json toJson(const ResultSources& sources);

/// [{"setUp": "reversedJoint@elbow", "why": "...", "question": "...", "odds": x}], as results and diagnoses list them
nlohmann::json setUpsJson(const std::vector<WrongSetUp>& setUps);

/// Parts of a result: an averaged estimate, its task, and what its captures might not show (the pose that would show it
/// is the planner's to find). Null where there is none.
nlohmann::json averagedJson(const Averaged& averaged);
nlohmann::json taskJson(const CalibrationResult& result);
nlohmann::json undetectableJson(const CalibrationResult& result);
/// Suspicious captures, boards and settings, as results and diagnoses list them.
nlohmann::json suspiciousJson(const std::vector<DataAnomaly>& anomalies);

/// RESULT.json: estimates with uncertainty, assumptions, and the prediction of every corner for reports.
nlohmann::json resultJson(const FittedModel& fitted, const ResultSources& inputs);

/// Robot and scene as read from a result file, without uncertainties.
struct StoredResult {
  std::vector<std::string> terms;       // "jointOffset@LKneePitch"
  std::map<std::string, double> values; // "jointOffset@LKneePitch.o" -> value [the unknown's unit]
  StoredPlacements placements;
  std::string definitions = "[]"; // user-defined effects: a JSON list
  Noise noise;                    // noise levels of the fit
  bool usable = false;
  std::string robot = "V6";              // its model
  std::string sentence;                  // the verdict; empty: not in the file
  std::vector<std::string> reasons;      // why it must not be used; empty if usable, or of an older version:
  bool hasReasons = false;               // whether the file has any such list
  std::map<std::string, double> learned; // 1 - posterior sigma / prior sigma, by the same names as `values`
  ResultSources inputs;                  // the sets that it was made from
};

/// Reads a result file. Throws InputError with file, location, expected and found.
StoredResult readResult(const std::filesystem::path& file);
/// The same from a document; `name` stands for the file in messages.
StoredResult parseResult(const nlohmann::json& document, const std::string& name);

/// Throws InputError for the result of captures that could not be fitted, which holds findings but no estimates.
void requireEstimates(const nlohmann::json& all, const std::string& name);

} // namespace naocal
