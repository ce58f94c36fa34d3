#pragma once

#include "analysis/Dataset.hpp"

#include "diagnosis/anomalies/MendedMeasurements.hpp"
#include "poses/NextPoses.hpp"

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace naocal {

/// Ends a search that is no longer wanted.
struct SearchEnded {};

/// Interactive analysis of captures: add and drop effects, test candidates, go back. Not thread-safe; independent of
/// sockets. Reports every change to the sink, in display units.
///
/// Kinds of messages: "set" (the dataset and the available effects; again after a change of custom effects), "ladder"
/// (all model revisions, and the current one), "fit" (estimates and residuals of the model), "diagnosis" (what it
/// lacks), "next" (proposed poses), "compared" (errors on other captures).
class AnalysisSession {
public:
  using MessageSink = std::function<void(const std::string& kind, const nlohmann::json& content)>;
  AnalysisSession(Dataset opened, MessageSink tell);

  /// Fits the current model, a modified one that becomes the last revision (`Session`), or an earlier one. Throw
  /// InputError for impossible changes.
  void fit();
  void add(const std::vector<std::string>& labels);
  void drop(const std::string& label);
  void goTo(std::size_t number);

  /// Called before a search adds an effect, with the number found so far; false ends the search: SearchEnded is thrown.
  using GoesOn = std::function<bool(std::size_t found)>;

  /// Searches for what the current model lacks, as `diagnose` does; takes seconds.
  void search(const GoesOn& goesOn = always);
  /// Proposes poses that best resolve the open questions of the model, after a search if there was none; takes seconds.
  void proposePoses(std::size_t count, const GoesOn& goesOn = always);
  /// Errors of the fit's prediction on captures not used for it.
  void compareWith(const Dataset& others);
  /// The content of a file for the current model: "result.json", "diagnosis.json", "poses.json", "model.json",
  /// "report.html" (of the result), "diagnosis.html", "session.json". Throws InputError for another name, or for
  /// "poses.json" without proposed poses. Of a diagnosis after a search if there was none.
  std::string generateFile(const std::string& name, const GoesOn& goesOn = always);

  /// Adds a custom effect, or replaces the one of the same name, as a new revision: as a term if it belongs to one
  /// joint, otherwise as a candidate at every joint.
  void defineEffect(const nlohmann::json& effect);

  /// Validates a custom effect for these captures: {"ok": true}, or {"ok": false, "sentence": .., "letter": position in
  /// the correction's text or absent}. May run concurrently with the other functions.
  nlohmann::json checkEffect(const nlohmann::json& effect) const;

private:
  static constexpr const char* definitionsName = "your own effects"; // file name in error messages

  std::vector<Effect> effects(const ModelRevision& rung) const;
  void tellSet(const ModelRevision& rung);
  void tellLadder() const;
  void keepSession() const;
  /// Labels of the current model's terms and of the set-ups that it mends.
  std::vector<std::string> terms() const;
  void enter(Session session);
  DiagnosisOptions options(const ModelRevision& rung) const;
  const Diagnosis& diagnosis(const GoesOn& goesOn);
  static bool always(std::size_t) { return true; }

  const Dataset opened_;
  const std::shared_ptr<const Measurements> measurements_; // as given
  MendedMeasurements mended_;                              // as the current model takes them
  MessageSink tell_;
  Session session_;
  ErrorUnit errors_;                   // of the model that was fitted last
  std::string toldDefinitions_;        // custom effects last reported
  nlohmann::json result_;              // RESULT.json document of the current model
  std::optional<Diagnosis> diagnosis_; // of the current model; absent: not searched yet
  std::optional<NextPoses> next_;      // of the current model; absent: not proposed yet
};

} // namespace naocal
