#include "diagnosis/StepwiseSelection.hpp"

#include "calibration/Fit.hpp"
#include "calibration/ModelUncertainty.hpp"
#include "calibration/Uncertainty.hpp"
#include "diagnosis/CandidateJudgement.hpp"
#include "diagnosis/evidence/Aliasing.hpp"
#include "diagnosis/evidence/Power.hpp"
#include "estimation/CandidateTerms.hpp"
#include "estimation/Model.hpp"
#include "estimation/ModelBuilder.hpp"
#include "inference/ModelWindow.hpp"
#include "inference/Prequential.hpp"
#include "inference/Thresholds.hpp"
#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

namespace naocal {

namespace {

/// Calibration with a fallback: if an accident makes the search infeasible, fixes joints to their readings and keeps
/// all corners at full weight.
WeighedCalibration calibrateOrHold(const Measurements& measurements, const Model& model, CalibrationOptions options) {
  try {
    return calibrateWeighing(measurements, model, options);
  } catch (const InputError&) {
    options.estimateNoise = options.robust = false;
    options.noise.pose = options.noise.reapproach = options.noise.stance = 0;
    return calibrateWeighing(measurements, model, options);
  }
}

/// The limit in which `whole` becomes `part`, or null.
const Limit* findLimit(const Effect& part, const Effect& whole) {
  const auto found = std::find_if(whole.limits.begin(), whole.limits.end(),
                                  [&](const Limit& limit) { return limit.effect == part.name; });
  return found == whole.limits.end() ? nullptr : &*found;
}

/// Whether the Wald statistic exceeds leastZ^2 per unknown.
bool isNeeded(const Term& term, const CalibrationResult& fit, double leastZ = 2) {
  return computeWald(fit, term) > leastZ * leastZ * static_cast<double>(term.effect.unknowns.size());
}

} // namespace

StepwiseSelection::StepwiseSelection(const Measurements& measurements, const Model& model,
                                     const DiagnosisOptions& options)
    : first_{calibrateOrHold(measurements, model, options.calibration)}, measurements_{first_.weighed ? *first_.weighed
                                                                                                      : measurements},
      options_{options}, candidates_{candidateTerms(measurements, options.calibration.effects)}, added_{options.with},
      model_{model}, fit_{first_.result} {
  std::erase_if(candidates_, [&](const Term& term) { return model_.find(term.label()) != nullptr; });
  for (const Term& term : candidates_) {
    CandidateFinding& finding = findings_.emplace_back(CandidateFinding{.term = term});
    finding.evidence.bayes = -std::numeric_limits<double>::infinity();
    if (const auto why = untestableReason(term.effect, term.placeIndex, measurements)) {
      finding.state = CandidateState::noData;
      finding.why = *why;
    }
  }
}

/// Uses the noise levels and weights of the first calibration, which its likeliest explanation implies, so that all
/// steps are comparable.
CalibrationResult StepwiseSelection::calibrateFrom(const Model& model, std::optional<Eigen::VectorXd> start) const {
  CalibrationOptions options = options_.calibration;
  options.start = std::move(start);
  options.noise = first_.result.noise;
  options.estimateNoise = options.testMissingEffects = options.robust = false;
  return calibrate(measurements_, model, options);
}

std::vector<Term> StepwiseSelection::testableTerms() const {
  std::vector<Term> result;
  for (const CandidateFinding& finding : findings_) {
    if (finding.state != CandidateState::noData && !model_.find(finding.term.label())) {
      result.push_back(finding.term);
    }
  }
  return result;
}

std::shared_ptr<const CandidateTests> StepwiseSelection::testModel() const {
  return isFirst() && first_.tests
             ? first_.tests
             : std::make_shared<const CandidateTests>(FittedModel{measurements_, model_, fit_}, testableTerms(),
                                                      options_.calibration.candidateTests);
}

CandidateFinding& StepwiseSelection::findingOf(const std::string& label) {
  return *findFinding(findings_, label);
}

void StepwiseSelection::recordStep(const CandidateTests& candidateTests, Diagnosis& diagnosis) {
  constexpr std::size_t few = 10;
  recordEvidence(candidateTests, diagnosis.steps.size());
  std::vector<std::size_t> first = candidateTests.candidatesByRank();
  first.resize(std::min(first.size(), few));
  findProposals(candidateTests);
  std::vector<std::vector<std::size_t>> asked = proposals_;
  for (const std::size_t candidate : first) {
    asked.push_back({candidate});
  }
  const std::optional<CrossValidation> held = crossValidate(candidateTests, model_, diagnosis.suggested, asked);
  const std::size_t alone = proposals_.size(); // index of the first candidate alone
  for (std::size_t i = 0; i < first.size(); ++i) {
    CandidateFinding& finding = findingOf(candidateTests.candidates()[first[i]]);
    if (finding.step == diagnosis.steps.size()) {
      if (held) {
        finding.heldOutBefore = held->beforePx;
        finding.heldOutAfter = held->afterPx[alone + i];
      }
      finding.addedVariable = computeAddedVariable(candidateTests, model_, first[i]);
    }
  }
  if (held) {
    for (std::size_t i = alone; i-- > 0;) {
      if (held->afterPx[i] >= held->beforePx) {
        proposals_.erase(proposals_.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
  }
  appendStep(candidateTests, held, diagnosis);
}

std::vector<LikelyEffects> StepwiseSelection::listPredicting(const CandidateTests& candidateTests) {
  refuted_.clear();
  while (true) {
    std::vector<LikelyEffects> likely = listLikelyEffects(candidateTests.measured(), refuted_);
    const std::size_t before = refuted_.size();
    if (!likely.empty()) {
      std::copy_if(likely.front().groups.begin(), likely.front().groups.end(), std::inserter(refuted_, refuted_.end()),
                   [&](std::size_t candidate) { return !predictsFurtherPoses(candidateTests, candidate); });
    }
    if (refuted_.size() == before) {
      return likely;
    }
  }
}

void StepwiseSelection::findProposals(const CandidateTests& candidateTests) {
  constexpr std::size_t most = 4;
  const std::vector<LikelyEffects> likely = listPredicting(candidateTests);
  for (std::size_t i = 0; i < candidateTests.candidates().size(); ++i) {
    findingOf(candidateTests.candidates()[i]).predicts = !refuted_.contains(i);
  }
  namedEvidence_ = likely.empty() ? 0 : likely.front().evidence;
  std::vector<std::vector<std::size_t>> all =
      isFirst() ? listExplanations(candidateTests) : std::vector<std::vector<std::size_t>>{};
  if (all.empty()) {
    std::transform(likely.begin(), likely.end(), std::back_inserter(all), std::mem_fn(&LikelyEffects::groups));
  }
  proposals_.clear();
  const double price = 2 * std::log(std::max<double>(1, static_cast<double>(candidateTests.candidates().size())));
  if (std::any_of(refuted_.begin(), refuted_.end(), [&](std::size_t candidate) {
        return candidateTests.candidateEvidence(candidate).bayes - price > namedEvidence_ + threshold::veryStrong;
      })) {
    return; // the captures differ over time as no effect says: what explains less is not the cause
  }
  for (std::vector<std::size_t>& effects : all) {
    std::erase_if(effects, [&](std::size_t candidate) { return !predictsFurtherPoses(candidateTests, candidate); });
    const bool isListed = std::find(proposals_.begin(), proposals_.end(), effects) != proposals_.end();
    if (!effects.empty() && !isListed && proposals_.size() < most) {
      proposals_.push_back(std::move(effects));
    }
  }
}

std::vector<std::vector<std::size_t>> StepwiseSelection::listExplanations(const CandidateTests& candidateTests) const {
  std::vector<std::vector<std::size_t>> result;
  for (const Explanation& explanation : first_.result.explanations) {
    std::vector<std::size_t> effects;
    for (const std::string& label : explanation.effects) {
      if (const auto candidate = candidateTests.findCandidate(label)) {
        effects.push_back(*candidate);
      }
    }
    if (effects.size() < explanation.effects.size()) { // beside a curve, which has no name
      break;
    }
    if (!effects.empty()) {
      std::sort(effects.begin(), effects.end());
      result.push_back(std::move(effects));
    }
  }
  return result;
}

void StepwiseSelection::recordEvidence(const CandidateTests& candidateTests, std::size_t step) {
  for (std::size_t i = 0; i < candidateTests.candidates().size(); ++i) {
    CandidateFinding& finding = findingOf(candidateTests.candidates()[i]);
    const GroupEvidence& evidence = candidateTests.candidateEvidence(i);
    finding.alone = step == 0 ? evidence : finding.alone;
    if (evidence.bayes > finding.evidence.bayes) {
      finding.evidence = evidence;
      finding.step = step;
      finding.plausible = isPlausible(finding.evidence, finding.term.sigmas());
    }
  }
}

void StepwiseSelection::appendStep(const CandidateTests& candidateTests, const std::optional<CrossValidation>& held,
                                   Diagnosis& diagnosis) {
  const LackOfFit misfit = testLackOfFit(candidateTests);
  SelectionStep step{.dropped = dropped_, .rmsPx = fit_.rmsPx, .noiseFloorPx = misfit.noiseFloorPx};
  step.chi2 = fit_.chi2;
  step.dof = fit_.dof;
  step.alarm = candidateTests.evidence().pValue;
  if (held) {
    step.heldOutPx = held->chosenPx;
    step.nextPx = held->nextPx;
  }
  if (diagnosis.steps.empty()) {
    diagnosis.lackOfFit = misfit;
  } else { // held-out errors of the step: the effect was chosen on all poses, so selection is part of the error
    step.added = added_.back();
    CandidateFinding& added = findingOf(step.added);
    added.heldOutBefore = diagnosis.steps.back().heldOutPx;
    added.heldOutAfter = step.heldOutPx;
  }
  diagnosis.steps.push_back(std::move(step));
}

Model StepwiseSelection::addTerm(const Term& term) const {
  std::vector<std::string> labels = added_;
  labels.push_back(term.label());
  return buildModel(measurements_, labels, options_.without, options_.calibration.effects);
}

Model StepwiseSelection::addSizedTerm(const CandidateTests& candidateTests, std::size_t candidate) const {
  const Model model = addTerm(candidateTests.candidates()[candidate]);
  const Term* const term = model.find(candidateTests.candidates()[candidate].label());
  if (!term) { // excluded by the user
    return model;
  }
  const GroupEvidence& evidence = candidateTests.candidateEvidence(candidate);
  const Eigen::ArrayXd information = evidence.covariance.diagonal().array().inverse();
  const Eigen::ArrayXd posterior = (information + term->sigmas().array().square().inverse()).inverse();
  Eigen::VectorXd expected = mapParameters(model_, fit_.unknowns, model),
                  variances = mapParameters(model_, fit_.covariance.diagonal(), model);
  expected.segment(eigenIndex(term->first), posterior.size()) = posterior * information * evidence.estimate.array();
  variances.segment(eigenIndex(term->first), posterior.size()) = posterior;
  return widenPriors(model, expected, variances).value_or(model);
}

bool StepwiseSelection::predictsFurtherPoses(const CandidateTests& candidateTests, std::size_t candidate) const {
  if (!isTransient(candidateTests.candidates()[candidate].effect)) {
    return true;
  }
  for (std::size_t cell = 0; cell < candidateTests.map().cells.size(); ++cell) {
    if (candidateTests.map().cells[cell].shape == DriverBasis::Shape::step &&
        candidateTests.curveEvidence(candidateTests.mounts().size() + cell).bayes >=
            candidateTests.candidateEvidence(candidate).bayes) {
      return false;
    }
  }
  return scorePrequentially(candidateTests.problem(), candidateTests.noise(), sortPosesByTime(measurements_), candidate)
      .predicts();
}

StepwiseSelection::Nearly StepwiseSelection::fitModelNearly(const Model& model, const Eigen::VectorXd& start) const {
  const FitMinimum minimum = naocal::fitForComparison(measurements_, model, fit_.noise, fit_.loss, start).minimum;
  return {minimum.linear.cost, minimum.state.unknowns};
}

std::optional<StepwiseSelection::Choice> StepwiseSelection::chooseNext(const CandidateTests& candidateTests) {
  constexpr double accuracy = 0.02; // of the difference of two costs by `fitModelNearly`
  const double before = fitModelNearly(model_, fit_.unknowns).cost;
  for (const std::vector<std::size_t>& effects : proposals_) {
    const std::size_t strongest = *std::max_element(effects.begin(), effects.end(), [&](std::size_t a, std::size_t b) {
      return candidateTests.candidateEvidence(a).bayes < candidateTests.candidateEvidence(b).bayes;
    });
    const Model larger = addSizedTerm(candidateTests, strongest);
    CandidateFinding& finding = findingOf(candidateTests.candidates()[strongest]);
    if (!larger.find(finding.term.label())) { // excluded by the user
      continue;
    }
    Nearly fit = fitModelNearly(larger, mapParameters(model_, fit_.unknowns, larger));
    if (fit.cost < before - accuracy) {
      if (finding.evidence.bayes == candidateTests.candidateEvidence(strongest).bayes) { // recorded at this step
        finding.chi2Drop = 2 * (before - fit.cost);
      }
      return Choice{strongest, std::move(fit.unknowns)};
    }
  }
  return std::nullopt;
}

void StepwiseSelection::markEquivalent(const Term& chosen, const Term& other) {
  findingOf(chosen).equivalent.push_back(other.label());
  CandidateFinding& twin = findingOf(other);
  if (twin.state != CandidateState::present) {
    twin.state = CandidateState::aliased;
    twin.equivalent.push_back(chosen.label());
  }
}

void StepwiseSelection::compareLimits(const Term& chosen) {
  for (const Term& other : candidates_) {
    const std::vector<std::string>& known = findingOf(chosen).equivalent;
    if (other.placeIndex != chosen.placeIndex || other.effect.placeKind != chosen.effect.placeKind ||
        findingOf(other).state == CandidateState::noData ||
        std::find(known.begin(), known.end(), other.label()) != known.end()) {
      continue;
    }
    const Limit* const ofOther = findLimit(chosen.effect, other.effect);
    if (!ofOther && !findLimit(other.effect, chosen.effect)) {
      continue;
    }
    std::vector<std::string> labels = added_;
    std::replace(labels.begin(), labels.end(), chosen.label(), other.label());
    const Model instead = buildModel(measurements_, labels, options_.without, options_.calibration.effects);
    if (!model_.find(chosen.label()) || !instead.find(other.label())) { // excluded by the user
      continue;
    }
    const double cost = fitModelNearly(instead, startWithInstead(chosen, other, instead)).cost;
    if (2 * (cost - fitModelNearly(model_, fit_.unknowns).cost) < threshold::maxEvidenceGap) {
      markEquivalent(chosen, other);
    }
  }
}

Eigen::VectorXd StepwiseSelection::startWithInstead(const Term& chosen, const Term& other, const Model& instead) const {
  Eigen::VectorXd start = mapParameters(model_, fit_.unknowns, instead);
  const Term& from = *model_.find(chosen.label());
  const Term& to = *instead.find(other.label());
  const Limit* const limit = findLimit(chosen.effect, other.effect);
  for (std::size_t i = 0; i < to.effect.unknowns.size(); ++i) {
    const std::string& name = to.effect.unknowns[i].name;
    double& value = start[eigenIndex(to.first + i)];
    for (std::size_t k = 0; k < from.effect.unknowns.size(); ++k) {
      value = from.effect.unknowns[k].name == name ? fit_.unknowns[eigenIndex(from.first + k)] : value;
    }
    value = limit && limit->unknown == name ? limit->value : value;
  }
  return start;
}

void StepwiseSelection::unmarkEquivalent(const std::string& one, const std::string& other) {
  std::erase(findingOf(one).equivalent, other);
  std::erase(findingOf(other).equivalent, one);
}

bool StepwiseSelection::add(const CandidateTests& candidateTests, const Choice& choice, Diagnosis& diagnosis) {
  const std::size_t most = std::max<std::size_t>(1, measurements_.poses.size() / 4);
  if (diagnosis.steps.size() > most) {
    return false;
  }
  const Term& term = candidateTests.candidates()[choice.candidate];
  CandidateFinding& finding = findingOf(term);
  finding.state = CandidateState::present;
  finding.evidence.bayes = std::max(finding.evidence.bayes, candidateTests.candidateEvidence(choice.candidate).bayes);
  for (std::size_t other : findEquivalents(candidateTests, choice.candidate)) {
    markEquivalent(term, candidateTests.candidates()[other]);
  }
  added_.push_back(term.label());
  diagnosis.suggested.push_back(term.label());
  refit(choice.start);
  dropSuperfluous(diagnosis.suggested);
  compareLimits(term);
  for (const Term& earlier : model_.terms()) {
    const auto found = std::find(diagnosis.suggested.begin(), diagnosis.suggested.end() - 1, earlier.label());
    if (found != diagnosis.suggested.end() - 1 && isNeeded(earlier, fit_, threshold::stillNeeded)) {
      unmarkEquivalent(earlier.label(), diagnosis.suggested.back());
    }
  }
  return true;
}

bool StepwiseSelection::fieldPersists(const ImageField& field, const CandidateTests& candidateTests) const {
  constexpr std::size_t most = 6;
  const std::vector<std::size_t> order = candidateTests.candidatesByEvidence();
  for (std::size_t i = 0; i < std::min(most, order.size()) && candidateTests.candidateEvidence(order[i]).bayes > 0;
       ++i) {
    const Model larger = addTerm(candidateTests.candidates()[order[i]]);
    const CalibrationResult fit = fitLarger(larger);
    if (refitField(field, {{measurements_, larger, fit}}, measurements_).fit.bayes < field.fit.bayes / 2) {
      return false;
    }
  }
  return true;
}

CalibrationResult StepwiseSelection::fitLarger(const Model& larger) const {
  return calibrateFrom(larger, mapParameters(model_, fit_.unknowns, larger));
}

void StepwiseSelection::refit(const std::optional<Eigen::VectorXd>& start) {
  const Model changed = buildModel(measurements_, added_, options_.without, options_.calibration.effects);
  fit_ = start ? calibrateFrom(changed, start) : fitLarger(changed);
  model_ = changed;
}

void StepwiseSelection::dropSuperfluous(std::vector<std::string>& suggested) {
  dropped_.clear();
  for (const Term& term : model_.terms()) {
    const bool earlier = std::find(suggested.begin(), suggested.end(), term.label()) < suggested.end() - 1;
    if (earlier && !isNeeded(term, fit_)) {
      dropped_.push_back(term.label());
      findingOf(term).state = CandidateState::inconclusive;
    }
  }
  for (CandidateFinding& finding : findings_) {
    if (finding.state == CandidateState::aliased) { // alias of a dropped effect
      for (const std::string& label : dropped_) {
        std::erase(finding.equivalent, label);
      }
      finding.state = finding.equivalent.empty() ? CandidateState::inconclusive : CandidateState::aliased;
    }
  }
  for (const std::string& label : dropped_) {
    std::erase(added_, label);
    std::erase(suggested, label);
  }
  if (!dropped_.empty()) {
    refit();
  }
}

} // namespace naocal
