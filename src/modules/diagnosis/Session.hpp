#pragma once

#include "calibration/ResultFile.hpp"
#include "diagnosis/Diagnosis.hpp"

#include <filesystem>
#include <functional>
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

/// A person's work with captures, from which it goes on another day, in the terminal or in the panel. Every model that
/// was tried stays: a changed one comes last, whichever model it was made from.
struct Session {
  std::vector<Rung> ladder;
  std::size_t at = 0;  // the rung that one stands on
  ResultInputs inputs; // the captures

  Rung& current() { return ladder.at(at); }
  const Rung& current() const { return ladder.at(at); }

  /// Labels of the current model's terms (`termLabels`); called where they matter, as a model may name what there is
  /// not.
  using Terms = std::function<std::vector<std::string>()>;

  /// The current model with another effect, or with one of the base model that was taken out. Throws InputError where
  /// the effect is in the model.
  void add(const std::string& label, const Terms& terms);
  /// The current model without one of its effects, of the base model's too. Throws InputError where it has no such one.
  void drop(const std::string& label, const Terms& terms);
  /// The current model as changed otherwise; `step` says how.
  void revise(Rung changed, const std::string& step);
  /// Back to the model that the current one was made from. Throws InputError where there is none.
  void undo();
  /// To any model that was tried. Throws InputError where there is none of that number.
  void goTo(std::size_t number);
};

/// The labels of a model's terms that were asked for, placements aside.
std::vector<std::string> termLabels(const Model& model);

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
