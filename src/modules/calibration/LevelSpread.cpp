#include "calibration/LevelSpread.hpp"

#include "inference/OwnEstimates.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/Parallel.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace naocal {

namespace {

/// Precision and gradient of the unknowns, priors included, at one noise level.
struct LinearSystem {
  Eigen::MatrixXd hessian;
  Eigen::VectorXd gradient;
};

LinearSystem systemAt(const Residuals::Linear& linear, const Eigen::VectorXd& unknowns, const Eigen::VectorXd& sigmas,
                      const Noise& noise) {
  const Eigen::VectorXd information = sigmas.cwiseAbs2().cwiseInverse();
  LinearSystem result{information.asDiagonal(), information.cwiseProduct(unknowns)};
  std::vector<MarginalSystem> parts(linear.poses.size());
  parallelFor(parts.size(), [&](std::size_t i) {
    marginalize(linear.poses[i], noise, jointErrorRoot(linear.poses[i], noise), parts[i]);
  });
  for (std::size_t pose = 0; pose < parts.size(); ++pose) {
    const std::vector<std::size_t>& seen = linear.poses[pose].unknowns;
    result.gradient(seen) += parts[pose].unknownGradient;
    result.hessian(seen, seen) += parts[pose].hessian;
  }
  return result;
}

} // namespace

double UncertainVariance::freedom() const {
  return std::min(4 + 2 / std::max(relativeSpread, 1e-9), 1e6);
}

LevelSpread::LevelSpread(const Residuals::Linear& linear, const Eigen::VectorXd& unknowns,
                         const Eigen::VectorXd& sigmas, const NoiseLevels& levels, double misfit) {
  const auto minimumAt = [&](const Noise& noise) {
    const LinearSystem system = systemAt(linear, unknowns, sigmas, noise);
    const Eigen::LLT<Eigen::MatrixXd> tempered{temperPrecision(system.hessian, sigmas, misfit)};
    return Minimum{-system.hessian.llt().solve(system.gradient), inverse(tempered)};
  };
  likeliest_ = minimumAt(levels.noise).covariance;
  for (const NoiseLevels::Level& level : levels.levels) {
    levels_.push_back({level.weight, minimumAt(level.noise)});
  }
  if (levels_.empty()) {
    levels_.push_back({1, {Eigen::VectorXd::Zero(sigmas.size()), likeliest_}});
  }
}

UncertainVariance LevelSpread::along(const Eigen::VectorXd& direction, bool moves) const {
  UncertainVariance result;
  double squares = 0;
  for (const Level& level : levels_) {
    const double shift = moves ? direction.dot(level.minimum.step) : 0,
                 variance = direction.dot(level.minimum.covariance * direction) + shift * shift;
    result.mean += level.weight * variance;
    squares += level.weight * variance * variance;
  }
  if (result.mean > 0) {
    result.relativeSpread = std::max(0.0, squares / (result.mean * result.mean) - 1);
    result.widening = result.mean / direction.dot(likeliest_ * direction);
  }
  return result;
}

} // namespace naocal
