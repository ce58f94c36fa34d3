#pragma once

#include "calibration/result/ResultFile.hpp"
#include "diagnosis/Diagnosis.hpp"

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// A model that a user tried: the base model with and without some effects, and its quality.
struct ModelRevision {
  std::vector<std::string> with, without;  // "E@P"
  std::string definitions = "[]";          // user-defined effects: a JSON list
  std::string step;                        // the change: "+ elasticity@LKneePitch"; empty for the first revision
  std::optional<std::size_t> from;         // index of the revision that it derives from
  double rmsPx = 0;                        // of the fit
  std::optional<SelectionStep> questioned; // set once the model has been tested
};

/// A user's analysis of captures, resumable in the terminal or the panel. Keeps every model tried; a new revision is
/// always appended, whichever revision it derives from.
struct Session {
  std::vector<ModelRevision> ladder;
  std::size_t at = 0;   // index of the current revision
  ResultSources inputs; // source captures

  ModelRevision& current() { return ladder.at(at); }
  const ModelRevision& current() const { return ladder.at(at); }

  /// Labels of the current model's terms (`termLabels`). Evaluated lazily, since a model may name terms that do not
  /// exist.
  using Terms = std::function<std::vector<std::string>()>;

  /// Appends the current model with further effects, or with removed effects of the base model restored, as one
  /// revision. Throws InputError if the model already contains one of them.
  void add(const std::vector<std::string>& labels, const Terms& terms);
  /// Appends the current model without one of its effects, base effects included. Throws InputError if it has no such
  /// effect.
  void drop(const std::string& label, const Terms& terms);
  /// Appends a revision with other changes; `step` describes them.
  void revise(ModelRevision changed, const std::string& step);
  /// Returns to the revision that the current one derives from. Throws InputError if there is none.
  void undo();
  /// Goes to the newest revision that derives from the current one. Throws InputError if there is none.
  void redo();
  /// Goes to any revision. Throws InputError if there is none of that number.
  void goTo(std::size_t number);
};

/// Labels of a model's requested terms, placements excluded.
std::vector<std::string> termLabels(const Model& model);

/// {"format": "naocal-session", "version": 1, "sets": [folders], "sha256": [of their captures.json], "at": 1, "ladder":
/// [{"with": ["E@P"], "without": [], "define": [user effects], "step": "+ E@P", "from": 0, "rmsPx": 0.52, "heldOutPx":
/// 0.55, "noiseFloorPx": 0.31, "alarm": 0.005}, ..]}; the last three are absent, or the held-out error null, if
/// unknown.
nlohmann::json sessionJson(const Session& session);

/// Throws InputError with file, location, expected and found.
Session readSession(const std::filesystem::path& file);

/// Throws InputError if the session's captures differ from these.
void requireSameCaptures(const Session& session, const ResultSources& inputs, const std::filesystem::path& file);

} // namespace naocal
