#include "poses/PoseCriterion.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <numeric>
#include <tbb/parallel_for.h>

namespace naocal {

namespace {

/// The one that, with `rest`, is judged best.
std::size_t bestBeside(const Eigen::MatrixXd& rest, const PoseJudge& judge,
                       const std::vector<Eigen::MatrixXd>& candidates) {
  std::vector<double> values(candidates.size());
  tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t i) { values[i] = judge(rest + candidates[i]); });
  return static_cast<std::size_t>(std::min_element(values.begin(), values.end()) - values.begin());
}

} // namespace

PoseJudge::PoseJudge(const Robot& robot, const Scene& scene, std::vector<std::size_t> joints, Criterion criterion,
                     bool known)
    : prior_{scene.priorInformation()}, joints_{std::move(joints)}, criterion_{criterion} {
  if (!known) {
    order_.resize(static_cast<std::size_t>(prior_.rows()) - robot.joints.size());
    std::iota(order_.begin(), order_.end(), static_cast<Eigen::Index>(robot.joints.size()));
  }
  order_.insert(order_.end(), joints_.begin(), joints_.end());
}

Eigen::MatrixXd PoseJudge::part(const Eigen::MatrixXd& information) const {
  return information(order_, order_);
}

Eigen::MatrixXd PoseJudge::covariance(const Eigen::MatrixXd& sum) const {
  // The offsets stand last: their block of L is the root of what is known of them with all else unknown.
  const auto count = static_cast<Eigen::Index>(joints_.size());
  const Eigen::LLT<Eigen::MatrixXd> factor{sum};
  const Eigen::MatrixXd corner = factor.matrixLLT().bottomRightCorner(count, count);
  const Eigen::MatrixXd inverse = corner.triangularView<Eigen::Lower>().solve(Eigen::MatrixXd::Identity(count, count));
  return inverse.transpose() * inverse;
}

double PoseJudge::operator()(const Eigen::MatrixXd& sum) const {
  const Eigen::MatrixXd covariance = this->covariance(sum);
  switch (criterion_) {
  case Criterion::determinant:
    return 2 * Eigen::LLT<Eigen::MatrixXd>{covariance}.matrixLLT().diagonal().array().log().sum();
  case Criterion::trace:
    return covariance.trace() / static_cast<double>(covariance.rows());
  case Criterion::eigenvalue:
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>{covariance, Eigen::EigenvaluesOnly}.eigenvalues().maxCoeff();
  case Criterion::worst:
    break;
  }
  return covariance.diagonal().maxCoeff();
}

std::vector<std::size_t> selected(const PoseJudge& judge, const std::vector<Eigen::MatrixXd>& candidates,
                                  std::size_t count, const std::vector<std::size_t>& kept) {
  std::vector<std::size_t> chosen = kept;
  Eigen::MatrixXd sum = judge.prior();
  for (const std::size_t index : kept) {
    sum += candidates[index];
  }
  while (chosen.size() < std::min(count, candidates.size())) {
    chosen.push_back(bestBeside(sum, judge, candidates));
    sum += candidates[chosen.back()];
  }
  double value = judge(sum);
  for (bool better = true; better;) {
    better = false;
    for (std::size_t i = kept.size(); i < chosen.size(); ++i) {
      const Eigen::MatrixXd rest = sum - candidates[chosen[i]];
      const std::size_t other = bestBeside(rest, judge, candidates);
      if (const double there = judge(rest + candidates[other]); there < value - 1e-9 * std::abs(value)) {
        chosen[i] = other;
        sum = rest + candidates[other];
        value = there;
        better = true;
      }
    }
  }
  return chosen;
}

} // namespace naocal
