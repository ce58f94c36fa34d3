#include "diagnosis/evidence/Aliasing.hpp"

#include "diagnosis/evidence/Power.hpp"
#include "inference/Thresholds.hpp"
#include "math/LinearAlgebra.hpp"

#include <Eigen/SVD>
#include <algorithm>

namespace naocal {

AliasMatrix computeAliasMatrix(const CandidateTests& candidateTests, const std::vector<std::string>& labels,
                               std::size_t most) {
  AliasMatrix result;
  std::vector<ColumnGroup> groups;
  for (const std::string& label : labels) {
    const auto candidate = candidateTests.findCandidate(label);
    if (candidate && candidateTests.candidateEvidence(*candidate).freedom > 0 && groups.size() < most) {
      result.labels.push_back(label);
      groups.push_back(candidateTests.problem().groups[*candidate]);
    }
  }
  const auto count = static_cast<Eigen::Index>(groups.size());
  result.correlations.setIdentity(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      result.correlations(i, j) = result.correlations(j, i) =
          canonicalCorrelation(candidateTests.evidence().information, groups[static_cast<std::size_t>(i)],
                               groups[static_cast<std::size_t>(j)]);
    }
  }
  return result;
}

namespace {

/// W with W^T block W = 1 on the directions that are not absorbed.
Eigen::MatrixXd orthonormaliser(const Eigen::MatrixXd& block) {
  const SymmetricEigen eigen = symmetricEigen(block);
  const double least = 1e-9 * std::max(1e-300, eigen.values.maxCoeff());
  const Eigen::VectorXd scale =
      (eigen.values.array() > least).select(eigen.values.array().max(least).sqrt().inverse(), 0.0);
  return eigen.vectors * scale.asDiagonal();
}

} // namespace

double canonicalCorrelation(const Eigen::MatrixXd& information, const ColumnGroup& one, const ColumnGroup& other) {
  if (one.count == 0 || other.count == 0) {
    return 0;
  }
  const Eigen::MatrixXd between =
      orthonormaliser(information.block(one.first, one.first, one.count, one.count)).transpose() *
      information.block(one.first, other.first, one.count, other.count) *
      orthonormaliser(information.block(other.first, other.first, other.count, other.count));
  return std::min(1.0, Eigen::JacobiSVD<Eigen::MatrixXd>{between}.singularValues()[0]);
}

double evidenceToSeparate(double correlation) {
  return 5.4 / std::max(1e-9, 1 - correlation);
}

std::vector<std::size_t> findEquivalents(const CandidateTests& candidateTests, std::size_t chosen) {
  std::vector<std::size_t> result;
  const GroupEvidence& best = candidateTests.candidateEvidence(chosen);
  const std::vector<ColumnGroup>& groups = candidateTests.problem().groups;
  const bool onlyData =
      !isPlausible(best, candidateTests.candidates()[chosen].sigmas()); // the prior size does not count then
  for (std::size_t i = 0; i < candidateTests.candidates().size(); ++i) {
    const GroupEvidence& other = candidateTests.candidateEvidence(i);
    if (i == chosen || other.freedom < 1 || other.bayes <= 0) {
      continue;
    }
    const double byData = best.likelihoodRatio - other.likelihoodRatio;
    const double byBoth = std::min(best.bayes - other.bayes, byData);
    const double behind = onlyData ? byBoth : best.bayes - other.bayes;
    const bool isWider = other.freedom > best.freedom; // only its prior speaks against it if it explains as much
    if ((isWider ? byBoth : behind) >= threshold::maxEvidenceGap) {
      continue;
    }
    const double like = canonicalCorrelation(candidateTests.evidence().information, groups[chosen], groups[i]);
    const bool tells = best.likelihoodRatio >= evidenceToSeparate(like);
    const bool besideIt =
        like < threshold::related && other.bayes >= threshold::veryStrong; // present in addition to the chosen one
    if ((behind < threshold::equallyLikely || !tells) && !besideIt) {
      result.push_back(i);
    }
  }
  return result;
}

} // namespace naocal
