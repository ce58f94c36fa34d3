#include "calibrate/Uncertainty.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace naocal {

namespace {

Eigen::MatrixXd inverse(const Eigen::MatrixXd& information) {
  return information.ldlt().solve(Eigen::MatrixXd::Identity(information.rows(), information.cols()));
}

/// Degrees of freedom of each unknown's variance, given the covariance of (ln encoder^2, ln pose^2).
Eigen::VectorXd freedoms(const Residuals::Linear& linear, const Eigen::VectorXd& sigmas, const JointNoise& noise,
                         const Eigen::VectorXd& variances) {
  const double step = 0.05;
  Eigen::MatrixXd slopes(variances.size(), 2);
  for (int level = 0; level < 2; ++level) {
    const auto moved = [&](double by) {
      Noise other = noise.noise;
      (level == 0 ? other.encoder : other.pose) *= std::exp(by / 2);
      return Eigen::VectorXd{inverse(informationOf(linear, sigmas, other)).diagonal()};
    };
    slopes.col(level) = (moved(step) - moved(-step)) / (2 * step);
  }
  Eigen::VectorXd result(variances.size());
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    const double spread = slopes.row(i) * noise.logCovariance * slopes.row(i).transpose();
    result[i] = std::clamp(2 * variances[i] * variances[i] / std::max(spread, 1e-300), 2.0, 1e6);
  }
  return result;
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
    numbers += 2 * fit.minimum.linear.poses[pose].corners;
  }
  const Eigen::VectorXd variances = inverse(fit.minimum.linear.hessian).diagonal();
  const double learned = (1 - variances.cwiseQuotient(sigmas.cwiseAbs2()).array()).sum();
  result.dof = numbers - learned;
  if (result.dof >= 1) {
    result.pValue = boost::math::cdf(complement(boost::math::chi_squared{result.dof}, result.chi2));
  }
  if (result.pValue < 0.001) {
    result.scale = std::sqrt(result.chi2 / result.dof);
  }
  return result;
}

Noise scaled(const Noise& noise, double factor) {
  return {noise.pixel * factor, noise.encoder * factor, noise.pose * factor};
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
  const Eigen::VectorXd variances = result.covariance.diagonal();
  measureDistances(measurements, model, fit, result);
  const Eigen::VectorXd freedom = freedoms(fit.minimum.linear, sigmas, noise, variances);
  for (Eigen::Index i = 0; i < sigmas.size(); ++i) {
    const double sigma = std::sqrt(variances[i]);
    const boost::math::students_t student{freedom[i]};
    result.estimates.push_back({.value = result.unknowns[i],
                                .sigma = sigma,
                                .halfWidth = boost::math::quantile(student, 0.975) * sigma,
                                .freedom = freedom[i],
                                .learned = 1 - std::sqrt(variances[i]) / sigmas[i]});
  }
  return result;
}

} // namespace naocal
