#include "poses/criteria/PoseCriterion.hpp"

#include "math/LinearAlgebra.hpp"
#include "math/SubsetSelection.hpp"

#include <Eigen/Cholesky>
#include <limits>
#include <numeric>

namespace naocal {

namespace {

/// Ratio of the target variances: 0.13 degrees, or 0.07 degrees with cameras and boards known.
constexpr double knownWeight = 0.13 * 0.13 / (0.07 * 0.07);

/// Order of the norm that replaces the maximum of variances: smooth, so that refinement does not get stuck.
constexpr double softness = 4;

/// Indices of a scene's unknowns that come after `first` ones.
std::vector<Eigen::Index> indicesAfter(std::size_t first, const PlanningScene& scene) {
  std::vector<Eigen::Index> result(static_cast<std::size_t>(scene.priorInformation().rows()) - first);
  std::iota(result.begin(), result.end(), eigenIndex(first));
  return result;
}

} // namespace

PoseCriterion::PoseCriterion(Eigen::MatrixXd prior, std::vector<Eigen::Index> others,
                             const std::vector<Eigen::Index>& targets, Criterion criterion)
    : prior_{std::move(prior)}, order_{std::move(others)}, targets_{eigenIndex(targets.size())}, criterion_{criterion} {
  order_.insert(order_.end(), targets.begin(), targets.end());
}

PoseCriterion::PoseCriterion(const Robot& robot, const PlanningScene& scene, const std::vector<std::size_t>& joints,
                             Criterion criterion, bool known)
    : PoseCriterion{scene.priorInformation(),
                    known ? std::vector<Eigen::Index>{} : indicesAfter(robot.joints.size(), scene),
                    {joints.begin(), joints.end()},
                    criterion} {}

Eigen::MatrixXd PoseCriterion::relevantInformation(const Eigen::MatrixXd& information) const {
  return information(order_, order_);
}

Eigen::MatrixXd PoseCriterion::covariance(const Eigen::MatrixXd& sum) const {
  // The targets come last: their block of L is the root of their information with all else marginalised.
  const Eigen::Index count = targets_;
  const Eigen::LLT<Eigen::MatrixXd> factor{sum};
  const Eigen::MatrixXd corner = factor.matrixLLT().bottomRightCorner(count, count);
  const Eigen::MatrixXd inverse = corner.triangularView<Eigen::Lower>().solve(Eigen::MatrixXd::Identity(count, count));
  return inverse.transpose() * inverse;
}

double PoseCriterion::operator()(const Eigen::MatrixXd& information) const {
  if (targets_ == 0) { // all poses are equally good
    return 0;
  }
  const Eigen::MatrixXd covariance = this->covariance(information);
  switch (criterion_) {
  case Criterion::determinant:
    return 2 * Eigen::LLT<Eigen::MatrixXd>{covariance}.matrixLLT().diagonal().array().log().sum();
  case Criterion::trace:
    return covariance.trace() / static_cast<double>(covariance.rows());
  case Criterion::eigenvalue:
    return symmetricEigenvalues(covariance).maxCoeff();
  case Criterion::worst:
  case Criterion::interaction:
  case Criterion::discriminate:
  case Criterion::time:
    break;
  }
  const Eigen::MatrixXd known =
      information.bottomRightCorner(targets_, targets_).llt().solve(Eigen::MatrixXd::Identity(targets_, targets_));
  const double sum =
      covariance.diagonal().array().pow(softness).sum() + (knownWeight * known.diagonal().array()).pow(softness).sum();
  return std::pow(sum, 1 / softness);
}

std::vector<std::size_t> selectPoses(const PoseCriterion& judge, const Eigen::MatrixXd& known,
                                     const std::vector<Eigen::MatrixXd>& candidates, std::size_t count) {
  std::vector<std::size_t> best;
  double least = std::numeric_limits<double>::infinity();
  for (const Criterion start : {Criterion::determinant, Criterion::trace, Criterion::eigenvalue, Criterion::worst}) {
    std::vector<std::size_t> chosen = selectGreedily(judge.withCriterion(start), known, candidates, count);
    improveByExchange(judge, known, candidates, chosen);
    Eigen::MatrixXd sum = known;
    for (const std::size_t index : chosen) {
      sum += candidates[index];
    }
    if (const double value = judge(sum); best.empty() || value < least) {
      best = chosen;
      least = value;
    }
  }
  return best;
}

} // namespace naocal
