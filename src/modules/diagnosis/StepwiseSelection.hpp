#pragma once

#include "diagnosis/Diagnosis.hpp"
#include "diagnosis/evidence/CrossValidation.hpp"
#include "diagnosis/views/ImageField.hpp"
#include "inference/ModelWindow.hpp"

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace naocal {

/// Extends the model effect by effect by what the search for explanations finds, and records the findings on each
/// candidate: first the effects of the calibration's explanations, then, linearised at each refit, what
/// `listLikelyEffects` finds likelier than that nothing else is missing.
class StepwiseSelection {
public:
  /// Calibrates the model. Keeps references to its arguments.
  StepwiseSelection(const Measurements& measurements, const Model& model, const DiagnosisOptions& options);
  StepwiseSelection(const StepwiseSelection&) = delete; // measurements_ may point into this object
  StepwiseSelection& operator=(const StepwiseSelection&) = delete;

  /// All measurements at the weights of the likeliest explanation of the first calibration: equal for all models.
  const Measurements& measurements() const { return measurements_; }
  const Model& model() const { return model_; }
  const CalibrationResult& fit() const { return fit_; }
  /// Candidates whose drivers were recorded and that the model lacks.
  std::vector<Term> testableTerms() const;
  /// The tests of the model: those that the calibration made, until an effect is added.
  std::shared_ptr<const CandidateTests> testModel() const;

  /// Records the model's step and the evidence of each candidate.
  void recordStep(const CandidateTests& candidateTests, Diagnosis& diagnosis);
  /// A candidate to add, and the approximate minimum of the model with it.
  struct Choice {
    std::size_t candidate = 0;
    Eigen::VectorXd start;
  };
  /// Evidence of the likeliest explanation by named effects that predict, at the last recorded step; 0 if none is
  /// likely.
  double namedEvidence() const { return namedEvidence_; }
  /// Transient effects of likely explanations that do not predict, at the last recorded step.
  const std::set<std::size_t>& refuted() const { return refuted_; }
  /// Next effect to add: the most evident of the likeliest explanation that lowers the held-out error and, refitted,
  /// the cost; transient effects must also predict the last poses and beat every step over time. Absent if none does.
  std::optional<Choice> chooseNext(const CandidateTests& candidateTests);
  /// Adds an effect, refits, and drops effects it made superfluous. False: the limit of a quarter of the poses is
  /// reached.
  bool add(const CandidateTests& candidateTests, const Choice& choice, Diagnosis& diagnosis);
  /// Whether a field within pictures keeps at least half of its evidence, whichever of the likeliest effects is added.
  bool fieldPersists(const ImageField& field, const CandidateTests& candidateTests) const;
  /// The model with one more effect; without it if the user excluded it.
  Model addTerm(const Term& term) const;
  /// Fits a model that contains this one's unknowns, starting from them.
  CalibrationResult fitLarger(const Model& larger) const;
  /// Findings on each candidate.
  const std::vector<CandidateFinding>& findings() const { return findings_; }
  /// Labels of the model's effects beyond the base model.
  const std::vector<std::string>& added() const { return added_; }

private:
  /// Keeps each candidate's strongest evidence.
  void recordEvidence(const CandidateTests& candidateTests, std::size_t step);
  /// Appends the step with its held-out errors.
  void appendStep(const CandidateTests& candidateTests, const std::optional<CrossValidation>& held,
                  Diagnosis& diagnosis);
  /// Likely explanations by named effects (`listLikelyEffects`), the likeliest without any that do not predict.
  std::vector<LikelyEffects> listPredicting(const CandidateTests& candidateTests);
  /// Finds effects that explain together: the first few explanations, likeliest first, without transient effects that
  /// do not predict.
  void findProposals(const CandidateTests& candidateTests);
  /// The named effects of the calibration's explanations.
  std::vector<std::vector<std::size_t>> listExplanations(const CandidateTests& candidateTests) const;
  CandidateFinding& findingOf(const std::string& label);
  CandidateFinding& findingOf(const Term& term) { return findingOf(term.label()); }
  /// Marks two effects as indistinguishable in these captures.
  void markEquivalent(const Term& chosen, const Term& other);
  /// Compares the chosen effect with effects of which it is a limit, or that are a limit of it: equivalent if a refit
  /// with the other in its place is hardly worse. At zero size the linearisation cannot show this.
  void compareLimits(const Term& chosen);
  Eigen::VectorXd startWithInstead(const Term& chosen, const Term& other, const Model& instead) const;
  /// Both effects are needed: neither substitutes the other.
  void unmarkEquivalent(const std::string& one, const std::string& other);
  /// Refits with the added effects, from `start` or from the present unknowns.
  void refit(const std::optional<Eigen::VectorXd>& start = {});
  /// The model with a candidate, its priors widened to the estimated size.
  Model addSizedTerm(const CandidateTests& candidateTests, std::size_t candidate) const;
  /// Drops earlier additions that the last one made superfluous.
  void dropSuperfluous(std::vector<std::string>& suggested);
  /// Whether no effect was added yet.
  bool isFirst() const { return added_.size() <= options_.with.size(); }
  /// Whether the candidate predicts poses that it was not fitted to.
  bool predictsFurtherPoses(const CandidateTests& candidateTests, std::size_t candidate) const;
  /// Approximate minimum (cost to 0.01) at the noise levels of this step.
  struct Nearly {
    double cost = 0;
    Eigen::VectorXd unknowns;
  };
  Nearly fitModelNearly(const Model& model, const Eigen::VectorXd& start) const;

  CalibrationResult calibrateFrom(const Model& model, std::optional<Eigen::VectorXd> start) const;

  WeighedCalibration first_;
  const Measurements& measurements_;
  const DiagnosisOptions& options_;
  std::vector<Term> candidates_;
  std::vector<std::string> added_;
  std::vector<std::string> dropped_; // labels dropped by the last addition
  Model model_;
  std::vector<std::vector<std::size_t>> proposals_; // of the last recorded step, that lower the held-out error
  double namedEvidence_ = 0;
  std::set<std::size_t> refuted_;
  CalibrationResult fit_;
  std::vector<CandidateFinding> findings_; // one per candidate
};

} // namespace naocal
