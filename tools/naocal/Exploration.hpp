#pragma once

#include "Sets.hpp"

#include "diagnosis/Diagnosis.hpp"
#include "diagnosis/Session.hpp"

#include <string>
#include <vector>

namespace naocal {

/// The loop of a person with a set: add, drop, look, undo. Every model that was tried is kept, and written to the
/// session's file, from which the same loop goes on another day.
class Exploration {
public:
  /// `first`: the model to begin with; of a session that goes on, only its own effects are new. `file`: the session's;
  /// may be empty.
  Exploration(const GivenSets& given, Rung first, std::string file);

  void add(const std::string& label);
  void drop(const std::string& label);
  /// Back to the model that this one was made from.
  void undo();

  void printLadder() const;
  void printCandidates() const;

private:
  Rung& here() { return session_.ladder[session_.at]; }
  /// Puts a model to the question. Throws InputError where no fit can start.
  Rung questioned(Rung rung);
  void tryOut(Rung rung, const std::string& step);
  void save() const;

  const GivenSets& given_;
  Measurements measurements_;
  std::string file_;
  Session session_;
  Diagnosis latest_;
};

} // namespace naocal
