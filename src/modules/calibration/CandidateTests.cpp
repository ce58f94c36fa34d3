#include "calibration/CandidateTests.hpp"

#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace naocal {

namespace {

std::vector<std::size_t> sortByBayes(std::span<const GroupEvidence> groups) {
  std::vector<std::size_t> order(groups.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return groups[a].bayes > groups[b].bayes; });
  return order;
}

} // namespace

CandidateTests::CandidateTests(const FittedModel& fitted, const std::vector<Term>& candidates,
                               const CandidateTestOptions& options)
    : wide_{fitted.measurements,
            fitted.model,
            candidates,
            {fitted.fit.state, fitted.fit.noise, fitted.fit.loss},
            options.map},
      measured_{wide_.problem(), fitted.fit.noise}, evidence_{computeEvidence(measured_, options.draws, options.seed)} {
}

std::vector<std::size_t> CandidateTests::candidatesByEvidence() const {
  return sortByBayes({evidence_.groups.data(), candidates().size()});
}

double CandidateTests::rankingScore(const GroupEvidence& evidence) const {
  const double numbers = 6 * static_cast<double>(poses().size());
  return std::max(evidence.bayes, evidence.likelihoodRatio - static_cast<double>(evidence.freedom) * std::log(numbers));
}

std::vector<std::size_t> CandidateTests::candidatesByRank() const {
  std::vector<std::size_t> order = candidatesByEvidence();
  std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
    return rankingScore(candidateEvidence(a)) > rankingScore(candidateEvidence(b));
  });
  return order;
}

std::vector<std::size_t> CandidateTests::curvesByEvidence() const {
  return sortByBayes({evidence_.groups.data() + candidates().size(), curveCount()});
}

std::optional<std::size_t> CandidateTests::findCandidate(const std::string& label) const {
  const auto found = std::find_if(candidates().begin(), candidates().end(),
                                  [&](const Term& candidate) { return candidate.label() == label; });
  return found == candidates().end() ? std::nullopt
                                     : std::optional{static_cast<std::size_t>(found - candidates().begin())};
}

} // namespace naocal
