#pragma once

#include "Sets.hpp"

#include "diagnose/Diagnosis.hpp"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// The loop of a person with a set: add, drop, look, undo. Every model that was tried is kept, and written to the
/// session's file, from which the same loop goes on another day.
class Exploration {
public:
  /// `asked`: what the model has from the start, and all effects that may be named. `file`: the session's; may be
  /// empty.
  Exploration(const GivenSets& given, DiagnosisOptions asked, std::string file);

  void add(const std::string& label);
  void drop(const std::string& label);
  /// Back to the model that this one was made from.
  void undo();

  void printLadder() const;
  void printCandidates() const;

private:
  /// A model that was tried: what it had beyond the base, how well it did, and which one it was made from.
  struct Rung {
    std::vector<std::string> with;
    std::optional<std::size_t> from;
    Step step;
  };

  /// Puts a model to the question. Throws InputError where no fit can start.
  Step questioned(const std::vector<std::string>& with);
  void tryOut(std::vector<std::string> with, std::optional<std::size_t> from);
  void load();
  void save() const;

  const GivenSets& given_;
  DiagnosisOptions asked_;
  Measurements measurements_;
  std::string file_;
  std::vector<Rung> rungs_;
  std::size_t here_ = 0; // which of them the model is
  Diagnosis latest_;
};

} // namespace naocal
