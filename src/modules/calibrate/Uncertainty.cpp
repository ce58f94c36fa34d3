#include "calibrate/Uncertainty.hpp"

#include "evidence/NoiseFloor.hpp"
#include "evidence/PoseMisfit.hpp"
#include "math/Parallel.hpp"
#include "math/Statistics.hpp"

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

/// `moves`: whether the estimate's own move counts.
Spread spreadOver(const Residuals::Linear& linear, const Eigen::VectorXd& unknowns, const Eigen::VectorXd& sigmas,
                  const std::vector<NoiseLevels::Level>& levels, double misfit, bool moves) {
  Spread result{Eigen::VectorXd::Zero(sigmas.size()), Eigen::VectorXd::Zero(sigmas.size())};
  for (const NoiseLevels::Level& level : levels) {
    const LinearMinimum there = linearMinimum(linear, unknowns, sigmas, level.noise);
    Eigen::VectorXd variance = misfit * there.covariance.diagonal();
    if (moves) {
      variance += there.step.cwiseAbs2();
    }
    result.variance += level.weight * variance;
    result.relativeSpread += level.weight * variance.cwiseAbs2();
  }
  result.relativeSpread = (result.relativeSpread.cwiseQuotient(result.variance.cwiseAbs2()).array() - 1).max(0);
  return result;
}

std::vector<NoiseLevels::Level> levelsOf(const NoiseLevels& levels) {
  return levels.levels.empty() ? std::vector<NoiseLevels::Level>{{levels.noise, 1}} : levels.levels;
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
void measureDistances(const Residuals& residuals, const Fit& fit, CalibrationResult& result) {
  std::vector<double> distances;
  double squares = 0;
  result.asReported = residuals.sightings(residuals.start(result.unknowns));
  for (const SightingResidual& sighting : result.asReported) {
    for (Eigen::Index i = 0; i < sighting.residual.cols(); ++i) {
      distances.push_back(sighting.residual.col(i).norm());
      squares += sighting.residual.col(i).squaredNorm();
    }
  }
  if (!std::isfinite(squares)) { // deflected as fitted, none was
    throw behindTheCamera();
  }
  result.rmsPx = std::sqrt(squares / static_cast<double>(distances.size()));
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  result.medianPx = *middle;
  result.sightings = residuals.sightings(fit.minimum.state);
}

} // namespace

CalibrationResult uncertain(const Measurements& measurements, const Model& model, const Fit& fit,
                            const NoiseLevels& levels) {
  CalibrationResult result;
  result.converged = fit.minimum.converged;
  result.iterations = fit.minimum.iterations;
  result.restartsChanged = fit.restartsChanged;
  result.state = fit.minimum.state;
  result.unknowns = fit.minimum.state.unknowns;
  result.noise = fit.noise;
  result.loss = fit.loss;
  const Eigen::VectorXd sigmas = model.sigmas();
  const Residuals::Linear& linear = fit.minimum.linear;
  result.covariance = inverse(linear.hessian);
  double numbers = 0;
  for (std::size_t pose = 0; pose < linear.poses.size(); ++pose) {
    result.chi2 += 2 * linear.eliminated[pose].cost;
    numbers += linear.poses[pose].freedom;
  }
  result.dof = numbers - (1 - result.covariance.diagonal().cwiseQuotient(sigmas.cwiseAbs2()).array()).sum();
  const DriverColumns none{.blocks = std::vector<std::vector<DriverColumns::Block>>(linear.poses.size())};
  const Residuals residuals{measurements, model, fit.noise, fit.loss};
  const std::vector<PoseRows> rows = residuals.rows(fit.minimum.state).value(); // as it was linearised there
  const PoseMisfit misfit = poseMisfit({rows, none, result.unknowns, sigmas, 0}, fit.noise);
  result.misfit = std::max({1.0, misfit.chi2 / misfit.freedom, result.chi2 / std::max(1.0, result.dof)});
  result.sigmaScale = std::sqrt(result.misfit);
  result.covariance *= result.misfit;
  measureDistances(residuals, fit, result);
  result.noiseFloorPx = noiseFloorPx(rows, fit.noise);
  const Spread spread = spreadOver(linear, result.unknowns, sigmas, levelsOf(levels), result.misfit, true);
  for (Eigen::Index i = 0; i < sigmas.size(); ++i) {
    result.estimates.push_back(estimate(result.unknowns[i], spread.variance[i], spread.relativeSpread[i], sigmas[i]));
  }
  return result;
}

Eigen::VectorXd levelWidening(const Residuals::Linear& linear, const Eigen::VectorXd& sigmas,
                              const NoiseLevels& levels) {
  const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(sigmas.size());
  const Eigen::VectorXd variance = linearMinimum(linear, nothing, sigmas, levels.noise).covariance.diagonal();
  const Spread spread = spreadOver(linear, nothing, sigmas, levelsOf(levels), 1, false);
  Eigen::VectorXd result(sigmas.size());
  for (Eigen::Index i = 0; i < sigmas.size(); ++i) {
    const Estimate wide = estimate(0, spread.variance[i], spread.relativeSpread[i], sigmas[i]);
    result[i] = wide.halfWidth / (1.96 * std::sqrt(variance[i]));
  }
  return result;
}

LinearMinimum linearMinimum(const Residuals::Linear& linear, const Eigen::VectorXd& unknowns,
                            const Eigen::VectorXd& sigmas, const Noise& noise) {
  const Eigen::VectorXd information = sigmas.cwiseAbs2().cwiseInverse();
  Eigen::MatrixXd hessian = information.asDiagonal();
  Eigen::VectorXd gradient = information.cwiseProduct(unknowns);
  std::vector<Eliminated> parts(linear.poses.size());
  inParallel(parts.size(), [&](std::size_t i) {
    eliminate(linear.poses[i], noise, deflectionRoot(linear.poses[i], noise), parts[i]);
  });
  for (std::size_t pose = 0; pose < parts.size(); ++pose) {
    const std::vector<std::size_t>& seen = linear.poses[pose].unknowns;
    gradient(seen) += parts[pose].unknownGradient;
    hessian(seen, seen) += parts[pose].hessian;
  }
  const Eigen::LLT<Eigen::MatrixXd> factor{hessian};
  return {-factor.solve(gradient), factor.solve(Eigen::MatrixXd::Identity(hessian.rows(), hessian.cols()))};
}

} // namespace naocal
