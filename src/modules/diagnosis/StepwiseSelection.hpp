#pragma once

#include "diagnosis/Diagnosis.hpp"
#include "diagnosis/views/ImageField.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// The last word on each candidate when the ladder ends, best first: its state, what the captures could have noticed of
/// it, and which others they cannot tell from it. `last`: the question to the last `model` and its `fit`; `suggested`:
/// labels in the order in which they were added.
std::vector<CandidateFinding> judgeCandidates(std::vector<CandidateFinding> findings, const CandidateTests& last,
                                              const Model& model, const CalibrationResult& fit,
                                              const std::vector<std::string>& suggested);

/// Whether an effect comes and goes: it varies with time or temperature.
bool isTransient(const Effect& effect);

/// The model that grows by one effect after the other, and what was found about each candidate on the way.
class StepwiseSelection {
public:
  StepwiseSelection(const Measurements& measurements, const Model& model, const DiagnosisOptions& options);

  const Model& model() const { return model_; }
  const CalibrationResult& fit() const { return fit_; }
  /// Candidates whose drivers were recorded and that are not in the model.
  std::vector<Term> testableTerms() const;

  /// Writes down the model's rung and what each candidate would explain.
  void recordStep(const CandidateTests& inquiry, Diagnosis& diagnosis);
  /// A candidate to add, and nearly the least of the model with it.
  struct Choice {
    std::size_t candidate = 0;
    Eigen::VectorXd start;
  };
  /// What to add next: the likeliest, by a fit of each of the first few, of those that lower the held-out error and,
  /// where they drift, predict the last poses and beat every step; absent when none beats the model.
  std::optional<Choice> chooseNext(const CandidateTests& inquiry);
  /// Adds it, fits, and drops what it has made superfluous. False: the ladder is as long as these captures bear.
  bool add(const CandidateTests& inquiry, const Choice& choice, Diagnosis& diagnosis);
  /// Where the ladder ends: effects that were added since one that only helps beside another, and that all together do
  /// not lower the held-out error, are taken back. False: there are none, or they do.
  bool takeBack(Diagnosis& diagnosis);
  /// Whether a field within pictures is still there, at least half of it, whichever of the likeliest is added.
  bool fieldPersists(const ImageField& field, const CandidateTests& inquiry) const;
  /// The model's fit once more, now with boards set aside that moved for a moment: its doubts name them.
  CalibrationResult refitWithoutDisplacedBoards() const;
  /// A fit of a model that has this one's unknowns, and starts from them.
  CalibrationResult fitLarger(const Model& larger) const;
  /// What was found about each candidate.
  const std::vector<CandidateFinding>& findings() const { return findings_; }
  /// Labels of what the model has beyond the base.
  const std::vector<std::string>& added() const { return added_; }

private:
  CandidateFinding& findingOf(const std::string& label);
  CandidateFinding& findingOf(const Term& term) { return findingOf(term.label()); }
  /// These captures cannot tell them apart.
  void markEquivalent(const Term& chosen, const Term& other);
  /// Effects of which the chosen one is a limit, or that are one of it: they are equivalent where a fit with them in
  /// its place is hardly worse. Linearised at no size they show nothing of it.
  void compareLimits(const Term& chosen);
  Eigen::VectorXd startWithInstead(const Term& chosen, const Term& other, const Model& instead) const;
  /// Both are needed: neither stands for the other.
  void unmarkEquivalent(const std::string& one, const std::string& other);
  /// The model with what was added, from `start`, else from where the present one's unknowns are.
  void refit(const std::optional<Eigen::VectorXd>& start = {});
  /// The model with one more effect.
  Model addTerm(const Term& term) const;
  /// The same with a candidate, its priors as wide as the evidence of its size asks for.
  Model addSizedTerm(const CandidateTests& inquiry, std::size_t candidate) const;
  /// Earlier additions that the last one has made superfluous.
  void dropSuperfluous(std::vector<std::string>& suggested);
  /// 2 ln(Bayes factor) that a candidate must exceed. The alarm alone guards the first addition. A later one must outweigh
  /// the number K of candidates that it was chosen from: 2 ln K, even odds beforehand that one of them is there. On 200
  /// simulated robots with two effects, half of the later additions below that were wrong.
  double leastEvidence(const CandidateTests& inquiry) const;
  /// Whether it foretells poses that it was not fitted to: of the first few only.
  bool predictsFurtherPoses(const CandidateTests& inquiry, std::size_t candidate) const;
  /// A model's least cost at the rung's levels of noise, to a hundredth, and where it lies.
  struct Nearly {
    double cost = 0;
    Eigen::VectorXd unknowns;
  };
  Nearly fitModelNearly(const Model& model, const Eigen::VectorXd& start) const;

  /// The ladder before an effect was added that only helps beside another.
  struct Before {
    std::vector<std::string> added;
    Model model;
    CalibrationResult fit;
    std::vector<CandidateFinding> findings;
    std::vector<std::string> suggested;
    std::size_t steps;
    double heldOutPx;
    std::string label; // of that effect
  };

  CalibrationResult calibrateFrom(const Model& model, std::optional<Eigen::VectorXd> start) const;

  const Measurements& measurements_;
  const DiagnosisOptions& options_;
  std::vector<Term> candidates_;
  std::vector<std::string> added_;
  std::vector<std::string> dropped_; // by the last addition
  Model model_;
  std::optional<Noise> levels_;         // of the first rung
  std::vector<std::string> misleading_; // labels of candidates that raise the held-out error of this rung,
  std::vector<std::string> byTwo_;      // and that lower it only beside another one
  std::vector<std::string> takenBack_;
  std::optional<Before> before_;
  CalibrationResult fit_;
  std::vector<CandidateFinding> findings_; // as the candidates
};

} // namespace naocal
