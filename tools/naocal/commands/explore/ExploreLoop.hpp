#pragma once

#include "console/CommandLine.hpp"
#include "console/print/PrintDiagnosis.hpp"
#include "diagnosis/Diagnosis.hpp"
#include "diagnosis/Session.hpp"
#include "diagnosis/anomalies/MendedMeasurements.hpp"

#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace naocal {

/// Interactive exploration of a set: adds and drops effects, asks where the model fails and what would explain it, and
/// goes back. Keeps every model revision and writes them to the session file, from which a later run continues.
class ExploreLoop {
public:
  /// The session file and the model file that `first` is of; may be empty.
  struct Files {
    std::string session, model;
  };
  /// `given` must outlive it. `first`: initial model; a continued session takes only its custom effects.
  ExploreLoop(const LoadedSets& given, ModelRevision first, Files files);

  /// The effect of a row of `printCandidates` ("1"), or the label itself.
  std::string labelOf(const std::string& word) const;

  void add(const std::string& label);
  void drop(const std::string& label);
  /// Returns to the revision that the current model was derived from.
  void undo();
  /// Goes to the newest revision that was derived from the current one.
  void redo();
  void goTo(std::size_t revision);

  void printLadder() const;
  void printCandidates(std::size_t rows = candidateRows) const;
  /// Everything known about one candidate.
  void printCandidate(const std::string& label) const;
  /// Errors of the current model by board and camera, and of the worst poses.
  void printWhere() const;

  /// Writes the current model's result, as `naocal solve` does.
  void saveResult(const std::string& file) const;
  /// Proposes poses that answer what is open; writes them to `file` unless it is empty.
  void proposePoses(const std::string& file) const;

  /// Labels that may be added, and those of the current model's terms.
  std::vector<std::string> candidates() const;
  std::vector<std::string> terms() const;

private:
  /// Tests the candidates of a model. Throws InputError if no fit is possible.
  ModelRevision questioned(ModelRevision rung);
  std::vector<Effect> effects(const ModelRevision& rung) const;
  nlohmann::json solvedJson(const ResultSources& inputs) const;
  DiagnosisOptions options(const ModelRevision& rung, const MendedMeasurements& mended) const;
  /// The current model as options of the command line.
  GivenOptions asked() const;
  void change(const std::function<void(Session&)>& change);
  void save() const;

  const LoadedSets& given_;
  std::shared_ptr<const Measurements> measurements_; // as given
  MendedMeasurements mended_;                        // as the current model takes them
  Files files_;
  std::vector<std::string> withInFile_; // effects that the model file adds
  Session session_;
  Diagnosis latest_;
};

} // namespace naocal
