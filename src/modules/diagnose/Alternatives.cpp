#include "diagnose/Alternatives.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

namespace naocal {

namespace {

constexpr double asLikely = 6;    // in 2 ln of the Bayes factor: a twentieth as likely
constexpr double hardlyLess = 14; // beyond that, correlation is no excuse
constexpr double tellable = 5.4;

/// W with W^T block W = 1 over what is not absorbed.
Eigen::MatrixXd orthonormaliser(const Eigen::MatrixXd& block) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen{block};
  const double least = 1e-9 * std::max(1e-300, eigen.eigenvalues().maxCoeff());
  const Eigen::VectorXd scale =
      (eigen.eigenvalues().array() > least).select(eigen.eigenvalues().array().max(least).sqrt().inverse(), 0.0);
  return eigen.eigenvectors() * scale.asDiagonal();
}

} // namespace

double correlation(const Inquiry& inquiry, std::size_t one, std::size_t other) {
  const Eigen::MatrixXd& information = inquiry.evidence().information;
  const ColumnGroup& a = inquiry.problem().groups[one];
  const ColumnGroup& b = inquiry.problem().groups[other];
  const Eigen::MatrixXd between = orthonormaliser(information.block(a.first, a.first, a.count, a.count)).transpose() *
                                  information.block(a.first, b.first, a.count, b.count) *
                                  orthonormaliser(information.block(b.first, b.first, b.count, b.count));
  return Eigen::JacobiSVD<Eigen::MatrixXd>{between}.singularValues()[0];
}

std::vector<std::size_t> equivalents(const Inquiry& inquiry, std::size_t chosen) {
  std::vector<std::size_t> result;
  const GroupEvidence& best = inquiry.ofCandidate(chosen);
  for (std::size_t i = 0; i < inquiry.candidates().size(); ++i) {
    const GroupEvidence& other = inquiry.ofCandidate(i);
    if (i == chosen || other.freedom < 1 || other.bayes <= 0) {
      continue;
    }
    const double behind = best.bayes - other.bayes;
    if (behind < asLikely ||
        (behind < hardlyLess && best.likelihoodRatio * (1 - correlation(inquiry, chosen, i)) < tellable)) {
      result.push_back(i);
    }
  }
  return result;
}

} // namespace naocal
