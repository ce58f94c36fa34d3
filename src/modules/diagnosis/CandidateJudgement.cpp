#include "diagnosis/CandidateJudgement.hpp"

#include "diagnosis/evidence/Aliasing.hpp"
#include "diagnosis/evidence/Power.hpp"
#include "inference/Thresholds.hpp"

#include <algorithm>

namespace naocal {

namespace {

/// Detection power and limits of a candidate, from its part of the evidence.
void senseFrom(const GroupEvidence& evidence, double criticalP, CandidateFinding& finding) {
  const Sensitivity sensed = computeSensitivity(evidence, finding.term.sigmas(), criticalP);
  finding.power = sensed.power;
  finding.minimalDetectable = sensed.detectable;
}

/// Whether no size up to three prior sigmas would be detected.
bool isBlind(const CandidateFinding& finding) {
  const Eigen::VectorXd sigmas = finding.term.sigmas();
  for (Eigen::Index k = 0; k < sigmas.size(); ++k) {
    if (finding.minimalDetectable[static_cast<std::size_t>(k)] <= 3 * sigmas[k]) {
      return false;
    }
  }
  return true;
}

/// Judges a candidate that the model lacks.
void judgeLeftOut(const GroupEvidence& evidence, double criticalP, CandidateFinding& finding) {
  senseFrom(evidence, criticalP, finding);
  if (finding.state == CandidateState::inconclusive) {
    const bool untestable = evidence.freedom < 1 || isBlind(finding);
    const bool taken = finding.evidence.bayes > evidence.bayes + 2; // explained by later additions
    const bool striking = evidence.pValue < criticalP;              // but the null may still be likelier
    finding.state = untestable && taken ? CandidateState::aliased
                    : untestable        ? CandidateState::absorbed
                    : striking && evidence.bayes > 0
                        ? (evidence.matters() ? CandidateState::present : CandidateState::trivial)
                    : !striking && finding.power >= threshold::power ? CandidateState::absent
                                                                     : CandidateState::inconclusive;
  }
}

/// Judges a candidate in the model; takes its size from the last fit.
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

/// Names the equivalents of the first few remaining candidates with evidence.
void nameEquivalents(const CandidateTests& last, std::vector<CandidateFinding>& findings) {
  constexpr std::size_t few = 10;
  const std::vector<std::size_t> order = last.candidatesByRank();
  for (std::size_t i = 0; i < std::min(few, order.size()) && last.rankingScore(last.candidateEvidence(order[i])) > 0;
       ++i) {
    CandidateFinding& finding = *findFinding(findings, last.candidates()[order[i]].label());
    if (finding.equivalent.empty()) {
      for (std::size_t other : findEquivalents(last, order[i])) {
        finding.equivalent.push_back(last.candidates()[other].label());
      }
    }
  }
}

} // namespace

CandidateFinding* findFinding(std::vector<CandidateFinding>& findings, const std::string& label) {
  const auto found = std::find_if(findings.begin(), findings.end(),
                                  [&](const CandidateFinding& finding) { return finding.term.label() == label; });
  return found == findings.end() ? nullptr : &*found;
}

std::vector<CandidateFinding> judgeCandidates(std::vector<CandidateFinding> findings, const CandidateTests& last,
                                              const Model& model, const CalibrationResult& fit,
                                              const std::vector<std::string>& suggested) {
  const double criticalP = last.evidence().criticalP;
  for (std::size_t i = 0; i < last.candidates().size(); ++i) {
    judgeLeftOut(last.candidateEvidence(i), criticalP, *findFinding(findings, last.candidates()[i].label()));
  }
  for (const Term& term : model.terms()) {
    if (CandidateFinding* const added = findFinding(findings, term.label())) {
      judgeAdded(term, fit, criticalP, *added);
    }
  }
  nameEquivalents(last, findings);
  const auto tier = [&](const CandidateFinding& finding) { // first addition first, untestable candidates last
    const bool leads = !suggested.empty() && finding.term.label() == suggested.front();
    const bool shown = finding.state != CandidateState::noData &&
                       (finding.state != CandidateState::absorbed || finding.evidence.bayes > 2);
    return leads ? 0 : shown ? 1 : 2;
  };
  std::stable_sort(findings.begin(), findings.end(), [&](const CandidateFinding& a, const CandidateFinding& b) {
    return tier(a) != tier(b) ? tier(a) < tier(b) : last.rankingScore(a.evidence) > last.rankingScore(b.evidence);
  });
  return findings;
}

} // namespace naocal
