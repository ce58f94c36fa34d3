// How the ladder goes on: what is added, what becomes superfluous.
#include "calibrate/Fit.hpp"
#include "calibrate/Priors.hpp"
#include "diagnose/Alternatives.hpp"
#include "diagnose/Ladder.hpp"
#include "evidence/Prequential.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/Parallel.hpp"
#include "residuals/Carried.hpp"

#include <algorithm>
#include <utility>

namespace naocal {

namespace {

/// Where `whole` becomes `part`, if it does.
const Limit* limitThatIs(const Effect& part, const Effect& whole) {
  const auto found = std::find_if(whole.limits.begin(), whole.limits.end(),
                                  [&](const Limit& limit) { return limit.effect == part.name; });
  return found == whole.limits.end() ? nullptr : &*found;
}

/// Its unknowns differ from zero by more than so many of their errors (Wald).
bool isNeeded(const Term& term, const CalibrationResult& fit, double leastZ = 2) {
  const auto first = static_cast<Eigen::Index>(term.first), count = term.sigmas().size();
  const Eigen::VectorXd values = fit.unknowns.segment(first, count);
  const double chi2 = values.dot(fit.covariance.block(first, first, count, count).ldlt().solve(values));
  return chi2 > leastZ * leastZ * static_cast<double>(count);
}

} // namespace

bool passes(const Effect& effect) {
  return std::any_of(effect.needs.begin(), effect.needs.end(),
                     [](Driver driver) { return driver == Driver::time || driver == Driver::temperature; });
}

Model Ladder::with(const Term& term) const {
  std::vector<std::string> labels = added_;
  labels.push_back(term.label());
  return makeModel(measurements_, labels, options_.without, options_.effects);
}

Model Ladder::withSized(const Inquiry& inquiry, std::size_t candidate) const {
  const Model model = with(inquiry.candidates()[candidate]);
  const Term* const term = model.find(inquiry.candidates()[candidate].label());
  if (!term) { // a person left it out
    return model;
  }
  const GroupEvidence& evidence = inquiry.ofCandidate(candidate);
  const Eigen::ArrayXd information = evidence.covariance.diagonal().array().inverse();
  const Eigen::ArrayXd posterior = (information + term->sigmas().array().square().inverse()).inverse();
  Eigen::VectorXd expected = carried(model_, fit_.unknowns, model),
                  variances = carried(model_, fit_.covariance.diagonal(), model);
  expected.segment(at(term->first), posterior.size()) = posterior * information * evidence.estimate.array();
  variances.segment(at(term->first), posterior.size()) = posterior;
  return withPriorsFor(model, expected, variances).value_or(model);
}

bool Ladder::foretells(const Inquiry& inquiry, std::size_t candidate) const {
  if (std::find(misleading_.begin(), misleading_.end(), inquiry.candidates()[candidate].label()) != misleading_.end()) {
    return false;
  }
  if (!passes(inquiry.candidates()[candidate].effect)) {
    return true;
  }
  for (std::size_t cell = 0; cell < inquiry.map().cells.size(); ++cell) {
    if (inquiry.map().cells[cell].shape == DriverCell::Shape::step &&
        inquiry.ofCurve(inquiry.mounts().size() + cell).bayes >= inquiry.ofCandidate(candidate).bayes) {
      return false;
    }
  }
  return prequential(inquiry.problem(), inquiry.noise(), posesInTime(measurements_), candidate).predicts();
}

Ladder::Nearly Ladder::nearlyFitted(const Model& model, const Eigen::VectorXd& start) const {
  const FitMinimum minimum = naocal::nearlyFitted(measurements_, model, fit_.noise, fit_.loss, start).minimum;
  return {minimum.linear.cost, minimum.state.unknowns};
}

std::optional<Ladder::Choice> Ladder::best(const Inquiry& inquiry) {
  constexpr double near = 10, far = 14; // in 2 ln of the Bayes factor: a thousandth as likely is no choice
  constexpr std::size_t most = 4;
  std::vector<std::size_t> order, likely = inquiry.candidatesByEvidence();
  std::erase_if(likely, [&](std::size_t candidate) { return inquiry.ofCandidate(candidate).bayes <= 0; });
  // one that is sure and negligible does not stand before one that matters
  std::stable_partition(likely.begin(), likely.end(), [&](std::size_t candidate) {
    return !inquiry.evidence().matters || inquiry.ofCandidate(candidate).matters();
  });
  const auto lasting = std::find_if(likely.begin(), likely.end(), [&](std::size_t candidate) {
    return !passes(inquiry.candidates()[candidate].effect);
  });
  const double least = lasting == likely.end() ? 0 : inquiry.ofCandidate(*lasting).bayes - far;
  for (const std::size_t candidate : likely) {
    const GroupEvidence& here = inquiry.ofCandidate(candidate);
    const GroupEvidence& first = inquiry.ofCandidate(order.empty() ? candidate : order.front());
    if (order.size() == most || here.bayes < first.bayes - near || here.bayes < least ||
        (inquiry.evidence().matters && here.matters() != first.matters())) {
      break;
    }
    if (foretells(inquiry, candidate)) {
      order.push_back(candidate);
    }
  }
  if (order.empty()) {
    return std::nullopt;
  }
  std::vector<Nearly> fits(order.size() + 1); // the last without any of them
  inParallel(fits.size(), [&](std::size_t i) {
    const Model model = i < order.size() ? withSized(inquiry, order[i]) : model_;
    fits[i] = nearlyFitted(model, carried(model_, fit_.unknowns, model));
  });
  std::optional<Choice> best;
  double bestBayes = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const GroupEvidence& evidence = inquiry.ofCandidate(order[i]);
    const double drop = 2 * (fits.back().cost - fits[i].cost);
    CandidateFinding& finding = findingOf(inquiry.candidates()[order[i]]);
    if (finding.evidence.bayes == evidence.bayes) { // it is this rung that its predicted fall is of
      finding.chi2Drop = drop;
    }
    const double bayes =
        evidence.bayes * drop / evidence.likelihoodRatio; // in the share of its predicted fall that comes true
    if (bayes > bestBayes) {
      bestBayes = bayes;
      best = Choice{order[i], fits[i].unknowns};
    }
  }
  return best;
}

void Ladder::equivalent(const Term& chosen, const Term& other) {
  findingOf(chosen).equivalent.push_back(other.label());
  CandidateFinding& twin = findingOf(other);
  if (twin.state != State::present) {
    twin.state = State::aliased;
    twin.equivalent.push_back(chosen.label());
  }
}

void Ladder::compareLimits(const Term& chosen) {
  constexpr double hardlyLess = 14; // in chi2: as of equivalent candidates
  for (const Term& other : candidates_) {
    const std::vector<std::string>& known = findingOf(chosen).equivalent;
    if (other.at != chosen.at || other.effect.place != chosen.effect.place ||
        std::find(known.begin(), known.end(), other.label()) != known.end()) {
      continue;
    }
    const Limit* const ofOther = limitThatIs(chosen.effect, other.effect);
    if (!ofOther && !limitThatIs(other.effect, chosen.effect)) {
      continue;
    }
    std::vector<std::string> labels = added_;
    std::replace(labels.begin(), labels.end(), chosen.label(), other.label());
    const Model instead = makeModel(measurements_, labels, options_.without, options_.effects);
    if (!model_.find(chosen.label()) || !instead.find(other.label())) { // a person left it out
      continue;
    }
    const double cost = nearlyFitted(instead, startInstead(chosen, other, instead)).cost;
    if (2 * (cost - nearlyFitted(model_, fit_.unknowns).cost) < hardlyLess) {
      equivalent(chosen, other);
    }
  }
}

Eigen::VectorXd Ladder::startInstead(const Term& chosen, const Term& other, const Model& instead) const {
  Eigen::VectorXd start = carried(model_, fit_.unknowns, instead);
  const Term& from = *model_.find(chosen.label());
  const Term& to = *instead.find(other.label());
  const Limit* const limit = limitThatIs(chosen.effect, other.effect);
  for (std::size_t i = 0; i < to.effect.unknowns.size(); ++i) {
    const std::string& name = to.effect.unknowns[i].name;
    double& value = start[at(to.first + i)];
    for (std::size_t k = 0; k < from.effect.unknowns.size(); ++k) {
      value = from.effect.unknowns[k].name == name ? fit_.unknowns[at(from.first + k)] : value;
    }
    value = limit && limit->unknown == name ? limit->value : value;
  }
  return start;
}

void Ladder::notEquivalent(const std::string& one, const std::string& other) {
  std::erase(findingOf(one).equivalent, other);
  std::erase(findingOf(other).equivalent, one);
}

bool Ladder::add(const Inquiry& inquiry, const Choice& choice, Diagnosis& diagnosis) {
  const std::size_t most = std::max<std::size_t>(1, measurements_.poses.size() / 4);
  if (diagnosis.steps.size() > most) {
    return false;
  }
  const Term& term = inquiry.candidates()[choice.candidate];
  if (!before_ && std::find(byTwo_.begin(), byTwo_.end(), term.label()) != byTwo_.end()) {
    const std::vector<Step>& steps = diagnosis.steps;
    before_.emplace(Before{added_, model_, fit_, findings_, diagnosis.suggested, steps.size(),
                           steps.back().heldOutPx.value_or(0), term.label()});
  }
  CandidateFinding& finding = findingOf(term);
  finding.state = State::present;
  finding.evidence.bayes = std::max(finding.evidence.bayes, inquiry.ofCandidate(choice.candidate).bayes);
  for (std::size_t other : equivalents(inquiry, choice.candidate)) {
    equivalent(term, inquiry.candidates()[other]);
  }
  added_.push_back(term.label());
  diagnosis.suggested.push_back(term.label());
  refit(choice.start);
  dropSuperfluous(diagnosis.suggested);
  compareLimits(term);
  constexpr double evident = 3.3; // of one that is hardly needed beside the last, that may be the right one
  for (const Term& earlier : model_.terms()) {
    const auto found = std::find(diagnosis.suggested.begin(), diagnosis.suggested.end() - 1, earlier.label());
    if (found != diagnosis.suggested.end() - 1 && isNeeded(earlier, fit_, evident)) {
      notEquivalent(earlier.label(), diagnosis.suggested.back());
    }
  }
  return true;
}

bool Ladder::takeBack(Diagnosis& diagnosis) {
  if (!before_) {
    return false;
  }
  added_ = std::move(before_->added);
  model_ = std::move(before_->model);
  fit_ = std::move(before_->fit);
  findings_ = std::move(before_->findings);
  dropped_.clear();
  diagnosis.suggested = std::move(before_->suggested);
  diagnosis.steps.resize(before_->steps - 1); // its rung is looked at once more
  takenBack_.push_back(before_->label);
  before_.reset();
  return true;
}

bool Ladder::stays(const ImageField& field, const Inquiry& inquiry) const {
  constexpr std::size_t most = 6;
  const std::vector<std::size_t> order = inquiry.candidatesByEvidence();
  for (std::size_t i = 0; i < std::min(most, order.size()) && inquiry.ofCandidate(order[i]).bayes > 0; ++i) {
    const Model larger = with(inquiry.candidates()[order[i]]);
    const CalibrationResult fit = fitOf(larger);
    if (again(field, {measurements_, larger, fit}, measurements_).fit.bayes < field.fit.bayes / 2) {
      return false;
    }
  }
  return true;
}

CalibrationResult Ladder::fitOf(const Model& larger) const {
  return calibrated(larger, carried(model_, fit_.unknowns, larger));
}

void Ladder::refit(const std::optional<Eigen::VectorXd>& start) {
  const Model changed = makeModel(measurements_, added_, options_.without, options_.effects);
  fit_ = start ? calibrated(changed, start) : fitOf(changed);
  model_ = changed;
}

void Ladder::dropSuperfluous(std::vector<std::string>& suggested) {
  dropped_.clear();
  for (const Term& term : model_.terms()) {
    const bool earlier = std::find(suggested.begin(), suggested.end(), term.label()) < suggested.end() - 1;
    if (earlier && !isNeeded(term, fit_)) {
      dropped_.push_back(term.label());
      findingOf(term).state = State::inconclusive;
    }
  }
  for (CandidateFinding& finding : findings_) {
    if (finding.state == State::aliased) { // by what is no longer there
      for (const std::string& label : dropped_) {
        std::erase(finding.equivalent, label);
      }
      finding.state = finding.equivalent.empty() ? State::inconclusive : State::aliased;
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
