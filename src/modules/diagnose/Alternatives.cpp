#include "diagnose/Alternatives.hpp"

#include "diagnose/Power.hpp"
#include "math/LinearAlgebra.hpp"

#include <Eigen/SVD>
#include <algorithm>

namespace naocal {

namespace {

constexpr double asLikely = 6;    // in 2 ln of the Bayes factor: a twentieth as likely
constexpr double hardlyLess = 14; // beyond that, correlation is no excuse
constexpr double related = 0.5;   // correlation below which neither explains what the other does
constexpr double evident = 10;    // in 2 ln of the Bayes factor: no chance finding

/// W with W^T block W = 1 over what is not absorbed.
Eigen::MatrixXd orthonormaliser(const Eigen::MatrixXd& block) {
  const SymmetricEigen eigen = symmetricEigen(block);
  const double least = 1e-9 * std::max(1e-300, eigen.values.maxCoeff());
  const Eigen::VectorXd scale =
      (eigen.values.array() > least).select(eigen.values.array().max(least).sqrt().inverse(), 0.0);
  return eigen.vectors * scale.asDiagonal();
}

} // namespace

double correlation(const Eigen::MatrixXd& information, const ColumnGroup& one, const ColumnGroup& other) {
  const Eigen::MatrixXd between =
      orthonormaliser(information.block(one.first, one.first, one.count, one.count)).transpose() *
      information.block(one.first, other.first, one.count, other.count) *
      orthonormaliser(information.block(other.first, other.first, other.count, other.count));
  return std::min(1.0, Eigen::JacobiSVD<Eigen::MatrixXd>{between}.singularValues()[0]);
}

double evidenceToTell(double correlation) {
  return 5.4 / std::max(1e-9, 1 - correlation);
}

std::vector<std::size_t> equivalents(const Inquiry& inquiry, std::size_t chosen) {
  std::vector<std::size_t> result;
  const GroupEvidence& best = inquiry.ofCandidate(chosen);
  const std::vector<ColumnGroup>& groups = inquiry.problem().groups;
  const bool onlyData = !isPlausible(best, inquiry.candidates()[chosen].sigmas()); // no size was expected then
  for (std::size_t i = 0; i < inquiry.candidates().size(); ++i) {
    const GroupEvidence& other = inquiry.ofCandidate(i);
    if (i == chosen || other.freedom < 1 || other.bayes <= 0) {
      continue;
    }
    const double byData = best.likelihoodRatio - other.likelihoodRatio;
    const double behind = onlyData ? std::min(best.bayes - other.bayes, byData) : best.bayes - other.bayes;
    if (behind >= hardlyLess) {
      continue;
    }
    const double like = correlation(inquiry.evidence().information, groups[chosen], groups[i]);
    const bool tells = best.likelihoodRatio >= evidenceToTell(like);
    const bool besideIt = like < related && other.bayes >= evident; // there as well, whichever else is
    if ((behind < asLikely || !tells) && !besideIt) {
      result.push_back(i);
    }
  }
  return result;
}

} // namespace naocal
