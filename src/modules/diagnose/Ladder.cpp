#include "diagnose/Ladder.hpp"

#include "calibrate/Fit.hpp"
#include "diagnose/Alternatives.hpp"
#include "diagnose/HeldOut.hpp"
#include "residuals/Candidates.hpp"
#include "residuals/Carried.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace naocal {

namespace {

bool has(const Model& model, const std::string& label) {
  return std::any_of(model.terms().begin(), model.terms().end(),
                     [&](const Term& term) { return term.label() == label; });
}

/// No lens and no detector is known better: smaller misfits within pictures are not worth a cause [px].
constexpr double knownLens = 0.1;

bool isPlausible(const GroupEvidence& evidence, const Eigen::VectorXd& sigmas) {
  return (evidence.estimate.cwiseAbs().array() <= 3 * sigmas.array()).all();
}

/// Its unknowns differ from zero by more than their errors (Wald).
bool isNeeded(const Term& term, const CalibrationResult& fit) {
  constexpr double leastZ = 2;
  const auto first = static_cast<Eigen::Index>(term.first), count = term.sigmas().size();
  const Eigen::VectorXd values = fit.unknowns.segment(first, count);
  const double chi2 = values.dot(fit.covariance.block(first, first, count, count).ldlt().solve(values));
  return chi2 > leastZ * leastZ * static_cast<double>(count);
}

} // namespace

Ladder::Ladder(const Measurements& measurements, const Model& model, const DiagnosisOptions& options)
    : measurements_{measurements}, options_{options}, candidates_{candidateTerms(measurements, options.effects)},
      added_{options.with}, model_{model}, fit_{calibrated(model_, options.calibration.start)} {
  std::erase_if(candidates_, [&](const Term& term) { return has(model_, term.label()); });
  for (const Term& term : candidates_) {
    CandidateFinding& finding = findings_.emplace_back(CandidateFinding{.term = term});
    finding.evidence.bayes = -std::numeric_limits<double>::infinity();
    if (const auto why = whyUntestable(term.effect, term.at, measurements)) {
      finding.state = State::noData;
      finding.why = *why;
    }
  }
}

/// No sighting is set aside: what a missing effect does to a board must not be taken for an accident.
CalibrationResult Ladder::calibrated(const Model& model, std::optional<Eigen::VectorXd> start) const {
  CalibrationOptions options = options_.calibration;
  options.start = std::move(start);
  options.setAside = false;
  options.largestCornerError = knownLens;
  CalibrationResult result = calibrate(measurements_, model, options);
  std::size_t doubted = 0;
  for (const Doubt& doubt : result.doubts) {
    doubted += doubt.corners.size();
  }
  constexpr std::size_t few = 20;
  if (few * doubted > measurements_.cornerCount) { // so many are not false: the model is, and must see them
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
    if (finding.state != State::noData && !has(model_, finding.term.label())) {
      result.push_back(finding.term);
    }
  }
  return result;
}

CandidateFinding& Ladder::findingOf(const Term& term) {
  const auto found = std::find_if(findings_.begin(), findings_.end(), [&](const CandidateFinding& finding) {
    return finding.term.label() == term.label();
  });
  return *found;
}

void Ladder::look(const Inquiry& inquiry, Diagnosis& diagnosis) {
  for (std::size_t i = 0; i < inquiry.candidates().size(); ++i) {
    CandidateFinding& finding = findingOf(inquiry.candidates()[i]);
    if (inquiry.ofCandidate(i).bayes > finding.evidence.bayes) {
      finding.evidence = inquiry.ofCandidate(i);
      finding.step = diagnosis.steps.size();
      finding.plausible = isPlausible(finding.evidence, finding.term.sigmas());
    }
  }
  std::vector<std::size_t> order = inquiry.candidatesByEvidence();
  order.resize(std::min<std::size_t>(order.size(), 10));
  const HeldOut held = heldOut(inquiry, order);
  for (std::size_t i = 0; i < order.size(); ++i) {
    CandidateFinding& finding = findingOf(inquiry.candidates()[order[i]]);
    if (finding.step == diagnosis.steps.size()) {
      finding.heldOutBefore = held.beforePx;
      finding.heldOutAfter = held.afterPx[i];
      finding.addedVariable = addedVariable(inquiry, model_, order[i]);
    }
  }
  const LackOfFit misfit = lackOfFit(inquiry);
  if (diagnosis.steps.empty()) {
    diagnosis.lackOfFit = misfit;
  }
  diagnosis.steps.push_back({diagnosis.steps.empty() ? "" : added_.back(), dropped_, fit_.rmsPx, held.beforePx,
                             misfit.noiseFloorPx, fit_.chi2, fit_.dof, inquiry.evidence().pValue});
}

double Ladder::refittedDrop(const Inquiry& inquiry, std::size_t candidate) const {
  Noise noise = inquiry.noise();
  noise.pose = inquiry.ofCandidate(candidate).level;
  std::vector<std::string> with = added_;
  with.push_back(inquiry.candidates()[candidate].label());
  const Model larger = makeModel(measurements_, with, options_.without, options_.effects);
  const auto cost = [&](const Model& model, const Eigen::VectorXd& start) {
    Loss loss;
    loss.scale = fit_.loss.scale * fit_.sigmaScale;
    Fit from{Noise{.pixel = noise.pixel, .encoder = -1, .pose = -1}, loss, {}};
    from.minimum.state.unknowns = start;
    return naocal::refit(measurements_, model, noise, loss, std::move(from)).minimum.linear.cost;
  };
  return 2 * (cost(model_, fit_.unknowns) - cost(larger, carried(model_, fit_.unknowns, larger)));
}

std::optional<std::size_t> Ladder::best(const Inquiry& inquiry) {
  constexpr double near = 10;
  constexpr std::size_t most = 4;
  const std::vector<std::size_t> order = inquiry.candidatesByEvidence();
  std::optional<std::size_t> best;
  double bestBayes = 0;
  for (std::size_t i = 0; i < std::min(most, order.size()); ++i) {
    const GroupEvidence& evidence = inquiry.ofCandidate(order[i]);
    if (evidence.bayes <= 0 || evidence.bayes < inquiry.ofCandidate(order[0]).bayes - near) {
      break;
    }
    const double drop = refittedDrop(inquiry, order[i]);
    findingOf(inquiry.candidates()[order[i]]).chi2Drop = drop;
    const double bayes = evidence.bayes + drop - evidence.fall;
    if (bayes > bestBayes) {
      bestBayes = bayes;
      best = order[i];
    }
  }
  return best;
}

bool Ladder::add(const Inquiry& inquiry, std::size_t candidate, Diagnosis& diagnosis) {
  const std::size_t most = std::max<std::size_t>(1, measurements_.poses.size() / 4);
  if (diagnosis.steps.size() > most) {
    return false;
  }
  const Term& term = inquiry.candidates()[candidate];
  CandidateFinding& finding = findingOf(term);
  finding.state = State::present;
  finding.evidence.bayes = std::max(finding.evidence.bayes, inquiry.ofCandidate(candidate).bayes);
  for (std::size_t other : equivalents(inquiry, candidate)) {
    finding.equivalent.push_back(inquiry.candidates()[other].label());
    CandidateFinding& twin = findingOf(inquiry.candidates()[other]);
    if (twin.state != State::present) {
      twin.state = State::aliased;
      twin.equivalent.push_back(term.label());
    }
  }
  added_.push_back(term.label());
  diagnosis.suggested.push_back(term.label());
  refit();
  dropSuperfluous(diagnosis.suggested);
  return true;
}

void Ladder::refit() {
  const Model changed = makeModel(measurements_, added_, options_.without, options_.effects);
  fit_ = calibrated(changed, carried(model_, fit_.unknowns, changed));
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
  for (const std::string& label : dropped_) {
    std::erase(added_, label);
    std::erase(suggested, label);
  }
  if (!dropped_.empty()) {
    refit();
  }
}

} // namespace naocal
