#include "diagnose/Ladder.hpp"

#include "diagnose/HeldOut.hpp"
#include "diagnose/Power.hpp"
#include "diagnose/SetUps.hpp"
#include "io/InputError.hpp"
#include "residuals/Candidates.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace naocal {

namespace {

/// A calibration; of captures of which an accident leads the search astray, with joints held to their readings and
/// every corner in full.
CalibrationResult calibratedOrHeld(const Measurements& measurements, const Model& model, CalibrationOptions options) {
  try {
    return calibrate(measurements, model, options);
  } catch (const InputError&) {
    options.estimateNoise = options.robust = false;
    options.noise.pose = options.noise.reapproach = options.noise.stance = 0;
    return calibrate(measurements, model, options);
  }
}

} // namespace

Ladder::Ladder(const Measurements& measurements, const Model& model, const DiagnosisOptions& options)
    : measurements_{measurements}, options_{options}, candidates_{candidateTerms(measurements, options.effects)},
      added_{options.with}, model_{model}, fit_{calibrated(model_, options.calibration.start)} {
  levels_ = fit_.noise;
  std::erase_if(candidates_, [&](const Term& term) { return model_.find(term.label()) != nullptr; });
  for (const Term& term : candidates_) {
    CandidateFinding& finding = findings_.emplace_back(CandidateFinding{.term = term});
    finding.evidence.bayes = -std::numeric_limits<double>::infinity();
    if (const auto why = whyUntestable(term.effect, term.at, measurements)) {
      finding.state = State::noData;
      finding.why = *why;
    }
  }
}

/// No sighting is set aside: what a missing effect does to a board must not be taken for an accident. Noise levels are
/// those of the first rung, found under the widest model: all rungs are compared at the same.
CalibrationResult Ladder::calibrated(const Model& model, std::optional<Eigen::VectorXd> start) const {
  CalibrationOptions options = options_.calibration;
  options.start = std::move(start);
  options.setAside = false;
  if (levels_) {
    options.noise = *levels_;
    options.estimateNoise = options.question = false;
    if (std::none_of(fit_.doubts.begin(), fit_.doubts.end(), std::mem_fn(&Doubt::whole))) {
      options.loss = fit_.loss; // else boards that had no weight get it back first
    }
  }
  CalibrationResult result = calibratedOrHeld(measurements_, model, options);
  std::size_t doubted = 0, elsewhere = 0;
  for (const Doubt& doubt : result.doubts) {
    (doubt.whole && doubt.distance > impossible ? elsewhere : doubted) += doubt.corners.size();
  }
  constexpr std::size_t few = 20;
  const auto many = [&](std::size_t corners) { return few * corners > measurements_.cornerCount; };
  if (many(doubted) || many(elsewhere / 2)) { // so many are not false: the model is, and must see them
    options.robust = false;
    result = calibrate(measurements_, model, options);
  }
  return result;
}

CalibrationResult Ladder::withoutMovedBoards() const {
  CalibrationOptions options = options_.calibration;
  options.start = fit_.unknowns;
  return calibrate(measurements_, model_, options);
}

std::vector<Term> Ladder::testable() const {
  std::vector<Term> result;
  for (const CandidateFinding& finding : findings_) {
    if (finding.state != State::noData && !model_.find(finding.term.label())) {
      result.push_back(finding.term);
    }
  }
  return result;
}

CandidateFinding& Ladder::findingOf(const std::string& label) {
  const auto found = std::find_if(findings_.begin(), findings_.end(),
                                  [&](const CandidateFinding& finding) { return finding.term.label() == label; });
  return *found;
}

void Ladder::look(const Inquiry& inquiry, Diagnosis& diagnosis) {
  for (std::size_t i = 0; i < inquiry.candidates().size(); ++i) {
    CandidateFinding& finding = findingOf(inquiry.candidates()[i]);
    finding.alone = diagnosis.steps.empty() ? inquiry.ofCandidate(i) : finding.alone;
    if (inquiry.ofCandidate(i).bayes > finding.evidence.bayes) {
      finding.evidence = inquiry.ofCandidate(i);
      finding.step = diagnosis.steps.size();
      finding.plausible = isPlausible(finding.evidence, finding.term.sigmas());
    }
  }
  std::vector<std::size_t> order = inquiry.candidatesByStanding();
  order.resize(std::min<std::size_t>(order.size(), 10));
  std::vector<std::vector<std::size_t>> asked; // each alone, then by two
  for (const std::size_t candidate : order) {
    asked.push_back({candidate});
  }
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      asked.push_back({order[i], order[j]});
    }
  }
  const std::optional<HeldOut> held = heldOut(inquiry, model_, diagnosis.suggested, asked);
  misleading_ = takenBack_;
  byTwo_.clear();
  for (std::size_t i = 0; i < order.size(); ++i) {
    CandidateFinding& finding = findingOf(inquiry.candidates()[order[i]]);
    if (held && held->afterPx[i] >= held->beforePx) { // of two that are missing one alone may not help
      bool helps = false;
      for (std::size_t k = order.size(); k < asked.size(); ++k) {
        const bool isAmong = std::find(asked[k].begin(), asked[k].end(), order[i]) != asked[k].end();
        helps = helps || (isAmong && held->afterPx[k] < held->beforePx);
      }
      (helps ? byTwo_ : misleading_).push_back(finding.term.label());
    }
    if (finding.step == diagnosis.steps.size()) {
      if (held) {
        finding.heldOutBefore = held->beforePx;
        finding.heldOutAfter = held->afterPx[i];
      }
      finding.addedVariable = addedVariable(inquiry, model_, order[i]);
    }
  }
  const LackOfFit misfit = lackOfFit(inquiry);
  Step step{.dropped = dropped_, .rmsPx = fit_.rmsPx, .noiseFloorPx = misfit.noiseFloorPx};
  step.chi2 = fit_.chi2;
  step.dof = fit_.dof;
  step.alarm = inquiry.evidence().pValue;
  if (held) {
    step.heldOutPx = held->chosenPx;
    step.nextPx = held->nextPx;
    if (before_ && held->chosenPx < before_->heldOutPx) {
      before_.reset();
    }
  }
  if (diagnosis.steps.empty()) {
    diagnosis.lackOfFit = misfit;
  } else { // an effect that was chosen on all poses is as good as its choice
    step.added = added_.back();
    CandidateFinding& added = findingOf(step.added);
    added.heldOutBefore = diagnosis.steps.back().heldOutPx;
    added.heldOutAfter = step.heldOutPx;
  }
  diagnosis.steps.push_back(std::move(step));
}

} // namespace naocal
