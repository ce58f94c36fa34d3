#include "calibrate/Uncertainty.hpp"

#include "calibrate/Tails.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace naocal {

namespace {

Eigen::MatrixXd inverse(const Eigen::MatrixXd& information) {
  return information.ldlt().solve(Eigen::MatrixXd::Identity(information.rows(), information.cols()));
}

/// Each unknown's variance, averaged over the noise levels that are possible, and how far it varies over them.
struct Spread {
  Eigen::VectorXd variance;       // mean over levels of the variance there and of the estimate's own move
  Eigen::VectorXd relativeSpread; // Var(variance) / variance^2
};

Spread spreadOver(const Residuals::Linear& linear, const Eigen::VectorXd& unknowns, const Eigen::VectorXd& sigmas,
                  const std::vector<JointNoise::Level>& levels) {
  Spread result{Eigen::VectorXd::Zero(sigmas.size()), Eigen::VectorXd::Zero(sigmas.size())};
  for (const JointNoise::Level& level : levels) {
    const LinearMinimum there = linearMinimum(linear, unknowns, sigmas, level.noise);
    const Eigen::VectorXd variance = there.covariance.diagonal() + there.step.cwiseAbs2();
    result.variance += level.weight * variance;
    result.relativeSpread += level.weight * variance.cwiseAbs2();
  }
  result.relativeSpread = (result.relativeSpread.cwiseQuotient(result.variance.cwiseAbs2()).array() - 1).max(0);
  return result;
}

/// A normal distribution of uncertain variance, as the Student's t of the same variance and kurtosis:
/// nu = 4 + 2 / (relative variance of the variance).
Estimate estimate(double value, double variance, double relativeSpread, double priorSigma) {
  const double freedom = std::min(4 + 2 / std::max(relativeSpread, 1e-9), 1e6);
  const double sigma = std::sqrt(variance);
  return {.value = value,
          .sigma = sigma,
          .halfWidth = studentHalfWidth(freedom) * sigma * std::sqrt((freedom - 2) / freedom),
          .freedom = freedom,
          .learned = 1 - sigma / priorSigma};
}

/// Distances of corners from where the joints' readings put them, with no deflection taken out.
void measureDistances(const Measurements& measurements, const Model& model, const Fit& fit, CalibrationResult& result) {
  const Residuals residuals{measurements, model, fit.noise, fit.loss};
  std::vector<double> distances;
  double squares = 0;
  result.asReported = residuals.sightings(residuals.start(result.unknowns));
  for (const SightingResidual& sighting : result.asReported) {
    for (Eigen::Index i = 0; i < sighting.residual.cols(); ++i) {
      distances.push_back(sighting.residual.col(i).norm());
      squares += sighting.residual.col(i).squaredNorm();
    }
  }
  result.rmsPx = std::sqrt(squares / static_cast<double>(distances.size()));
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  result.medianPx = *middle;
  result.sightings = residuals.sightings(fit.minimum.state);
}

} // namespace

Misfit misfitOf(const Fit& fit, const Eigen::VectorXd& sigmas) {
  Misfit result;
  double numbers = 0;
  for (std::size_t pose = 0; pose < fit.minimum.linear.poses.size(); ++pose) {
    result.chi2 += 2 * fit.minimum.linear.eliminated[pose].cost;
    numbers += fit.minimum.linear.poses[pose].numbers;
  }
  const Eigen::VectorXd variances = inverse(fit.minimum.linear.hessian).diagonal();
  const double learned = (1 - variances.cwiseQuotient(sigmas.cwiseAbs2()).array()).sum();
  result.dof = numbers - learned;
  if (result.dof >= 1) {
    result.pValue = chiSquaredTail(result.chi2, result.dof);
  }
  if (result.pValue < 0.001) {
    result.scale = std::sqrt(result.chi2 / result.dof);
  }
  return result;
}

Noise scaled(const Noise& noise, double factor) {
  return {noise.pixel * factor, noise.encoder * factor, noise.pose * factor, noise.stance * factor};
}

CalibrationResult uncertain(const Measurements& measurements, const Model& model, const Fit& fit,
                            const JointNoise& noise, const Misfit& misfit) {
  CalibrationResult result;
  result.converged = fit.minimum.converged;
  result.iterations = fit.minimum.iterations;
  result.restartsChanged = fit.restartsChanged;
  result.state = fit.minimum.state;
  result.unknowns = fit.minimum.state.unknowns;
  result.noise = scaled(fit.noise, 1 / misfit.scale);
  result.chi2 = misfit.chi2;
  result.dof = misfit.dof;
  result.pValue = misfit.pValue;
  result.sigmaScale = misfit.scale;
  result.loss = fit.loss;
  const Eigen::VectorXd sigmas = model.sigmas();
  result.covariance = inverse(fit.minimum.linear.hessian);
  measureDistances(measurements, model, fit, result);
  std::vector<JointNoise::Level> levels = noise.levels;
  for (JointNoise::Level& level : levels) {
    level.noise = scaled(level.noise, misfit.scale);
  }
  if (levels.empty()) {
    levels.push_back({fit.noise, 1});
  }
  const Spread spread = spreadOver(fit.minimum.linear, result.unknowns, sigmas, levels);
  for (Eigen::Index i = 0; i < sigmas.size(); ++i) {
    result.estimates.push_back(estimate(result.unknowns[i], spread.variance[i], spread.relativeSpread[i], sigmas[i]));
  }
  return result;
}

} // namespace naocal
