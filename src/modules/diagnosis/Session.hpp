#pragma once

#include "calibration/ResultFile.hpp"
#include "diagnosis/Diagnosis.hpp"

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// A model that a person tried: the base with and without some effects, and how well it did.
struct Rung {
  std::vector<std::string> with, without; // "E@P"
  std::string definitions = "[]";         // the person's own effects: a list of JSON
  std::string step;                       // what was done: "+ elasticity@LKneePitch"; empty for the first
  std::optional<std::size_t> from;        // which rung before it was changed
  double rmsPx = 0;                       // of the fit
  std::optional<Step> questioned;         // once it was put to the question
};

/// A person's work with captures, from which it goes on another day, in the terminal or in the panel.
struct Session {
  std::vector<Rung> ladder;
  std::size_t at = 0;  // the rung that one stands on
  ResultInputs inputs; // the captures
};

/// {"format": "naocal-session", "version": 1, "sets": [folders], "sha256": [of their captures.json], "at": 1, "ladder":
/// [{"with": ["E@P"], "without": [], "define": [user effects], "step": "+ E@P", "from": 0, "rmsPx": 0.52, "heldOutPx":
/// 0.55, "noiseFloorPx": 0.31, "alarm": 0.005}, ..]}; the last three are absent, or the error on unseen poses null,
/// where they are not known.
nlohmann::json sessionJson(const Session& session);

/// Throws InputError with file, place, what was expected and found.
Session readSession(const std::filesystem::path& file);

/// Throws InputError where the session is of other captures than these.
void requireSameCaptures(const Session& session, const ResultInputs& inputs, const std::filesystem::path& file);

} // namespace naocal
