#pragma once

#include "analysis/Dataset.hpp"

#include "poses/NextPoses.hpp"

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace naocal {

/// The loop of a person with captures: add, drop, look, go back. Knows no threads and no sockets: everything that
/// changes is told to whoever asked for it, in units that people read.
///
/// Told kinds: "set" (what was opened, the effects that there are; again when a person's own change), "ladder" (all
/// models that were tried, and the current one), "fit" (estimates and residuals of the model), "questions" (its
/// candidates, map, curves), "found" (what a search for all that is missing says), "next" (poses that would tell more),
/// "compared" (other captures' errors).
class AnalysisSession {
public:
  using MessageSink = std::function<void(const std::string& kind, const nlohmann::json& content)>;
  AnalysisSession(Dataset opened, MessageSink tell);

  /// Fits the current model, a changed one that comes last in the history (`Session`), or an earlier one. Throw
  /// InputError for what cannot be done.
  void fit();
  void add(const std::string& label);
  void drop(const std::string& label);
  void goTo(std::size_t number);

  /// Tests all candidates of the current model: seconds.
  void testCandidates();
  /// Adds what is missing as long as the captures bear it and `goesOn` agrees, without changing the model: many
  /// seconds.
  void searchMissing(const std::function<bool()>& goesOn);
  /// Proposes poses that would best tell what the model leaves open: some seconds.
  void proposePoses(std::size_t count);
  /// How well the fit predicts captures that it has not seen.
  void compareWith(const Dataset& others);
  /// What naocal would write of the model: "result.json", "diagnosis.json", "poses.json", "model.json", "report.html"
  /// of the result, "diagnosis.html", "session.json". Throws InputError for another name, or where nothing was
  /// proposed.
  std::string generateFile(const std::string& name);

  /// Takes a person's own effect in, in place of one of that name, as a new revision: in the model where it sits at a
  /// joint, else as a candidate everywhere.
  void defineEffect(const nlohmann::json& effect);

  /// Whether a person's own effect can be used with these captures: {"ok": true}, or {"ok": false, "sentence": ..,
  /// "letter": place in the correction's text or absent}. May be called while another thread works with the rest.
  nlohmann::json checkEffect(const nlohmann::json& effect) const;

private:
  static constexpr const char* definitionsName = "your own effects"; // in refusals, for a file

  std::vector<Effect> effects(const Rung& rung) const;
  void tellSet(const Rung& rung);
  void tellLadder() const;
  void keepSession() const;
  std::vector<std::string> terms() const;
  void enter(Session session);
  DiagnosisOptions options(const Rung& rung) const;
  const Diagnosis& diagnosis();

  const Dataset opened_;
  const Measurements measurements_;
  MessageSink tell_;
  Session session_;
  std::string toldDefinitions_;        // the person's own effects, as they were last told
  nlohmann::json result_;              // of its current model, as a file has it
  std::optional<Diagnosis> diagnosis_; // of it, once it was put to the question
  std::optional<NextPoses> next_;      // and proposed for
};

} // namespace naocal
