#include "diagnose/Judgement.hpp"

#include "diagnose/Alternatives.hpp"
#include "diagnose/Power.hpp"

#include <algorithm>

namespace naocal {

namespace {

CandidateFinding& findingOf(std::vector<CandidateFinding>& findings, const Term& term) {
  return *std::find_if(findings.begin(), findings.end(),
                       [&](const CandidateFinding& finding) { return finding.term.label() == term.label(); });
}

/// What these captures notice of a candidate, from its part in `evidence`.
void senseFrom(const GroupEvidence& evidence, double criticalP, CandidateFinding& finding) {
  const Sensitivity sensed = sensitivity(evidence, finding.term.sigmas(), criticalP);
  finding.power = sensed.power;
  finding.minimalDetectable = sensed.detectable;
}

/// Nothing of a plausible size would be noticed.
bool isBlind(const CandidateFinding& finding) {
  const Eigen::VectorXd sigmas = finding.term.sigmas();
  for (Eigen::Index k = 0; k < sigmas.size(); ++k) {
    if (finding.minimalDetectable[static_cast<std::size_t>(k)] <= 3 * sigmas[k]) {
      return false;
    }
  }
  return true;
}

/// A candidate that the model does not have.
void judgeLeftOut(const GroupEvidence& evidence, double criticalP, CandidateFinding& finding) {
  senseFrom(evidence, criticalP, finding);
  if (finding.state == State::inconclusive) {
    constexpr double enough = 0.8;
    const bool untestable = evidence.freedom < 1 || isBlind(finding);
    const bool taken = finding.evidence.bayes > evidence.bayes + 2; // by what was added since
    const bool striking = evidence.pValue < criticalP;              // but it may be less likely there than not
    finding.state = untestable && taken                    ? State::aliased
                    : untestable                           ? State::absorbed
                    : striking && evidence.bayes > 0       ? (evidence.matters() ? State::present : State::trivial)
                    : !striking && finding.power >= enough ? State::absent
                                                           : State::inconclusive;
  }
}

/// A candidate that the model has: its size is what the last fit says.
void judgeAdded(const Term& term, const CalibrationResult& fit, double criticalP, CandidateFinding& finding) {
  senseFrom(finding.evidence, criticalP, finding);
  for (std::size_t k = 0; k < term.effect.unknowns.size(); ++k) {
    const Estimate& estimate = fit.estimates[term.first + k];
    const auto row = static_cast<Eigen::Index>(k);
    finding.evidence.estimate[row] = estimate.value;
    finding.evidence.covariance(row, row) = estimate.sigma * estimate.sigma;
  }
  finding.plausible = isPlausible(finding.evidence, finding.term.sigmas());
}

/// The first few of those left out that explain something: what they cannot be told from.
void nameEquivalents(const Inquiry& last, std::vector<CandidateFinding>& findings) {
  constexpr std::size_t few = 10;
  const std::vector<std::size_t> order = last.candidatesByStanding();
  for (std::size_t i = 0; i < std::min(few, order.size()) && last.standing(last.ofCandidate(order[i])) > 0; ++i) {
    CandidateFinding& finding = findingOf(findings, last.candidates()[order[i]]);
    if (finding.equivalent.empty()) {
      for (std::size_t other : equivalents(last, order[i])) {
        finding.equivalent.push_back(last.candidates()[other].label());
      }
    }
  }
}

} // namespace

std::vector<CandidateFinding> judged(std::vector<CandidateFinding> findings, const Inquiry& last, const Model& model,
                                     const CalibrationResult& fit, const std::vector<std::string>& suggested) {
  const double criticalP = last.evidence().criticalP;
  for (std::size_t i = 0; i < last.candidates().size(); ++i) {
    judgeLeftOut(last.ofCandidate(i), criticalP, findingOf(findings, last.candidates()[i]));
  }
  for (const Term& term : model.terms()) {
    const auto added = std::find_if(findings.begin(), findings.end(), [&](const CandidateFinding& finding) {
      return finding.term.label() == term.label();
    });
    if (added != findings.end()) {
      judgeAdded(term, fit, criticalP, *added);
    }
  }
  nameEquivalents(last, findings);
  const auto tier = [&](const CandidateFinding& finding) { // the first addition leads; what cannot be tested comes last
    const bool leads = !suggested.empty() && finding.term.label() == suggested.front();
    const bool shown =
        finding.state != State::noData && (finding.state != State::absorbed || finding.evidence.bayes > 2);
    return leads ? 0 : shown ? 1 : 2;
  };
  std::stable_sort(findings.begin(), findings.end(), [&](const CandidateFinding& a, const CandidateFinding& b) {
    return tier(a) != tier(b) ? tier(a) < tier(b) : last.standing(a.evidence) > last.standing(b.evidence);
  });
  return findings;
}

} // namespace naocal
