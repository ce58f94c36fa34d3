#include "calibration/Uncertainty.hpp"

#include "calibration/LevelSpread.hpp"
#include "calibration/Outliers.hpp"
#include "calibration/ReadingErrors.hpp"
#include "calibration/result/Wording.hpp"
#include "inference/NoiseLevels.hpp"
#include "inference/OwnEstimates.hpp"
#include "inference/PoseMisfit.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/Statistics.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace naocal {

namespace {

Estimate estimate(double value, const UncertainVariance& variance, double priorSigma) {
  const double freedom = variance.freedom(), sigma = std::sqrt(variance.mean);
  return {.value = value,
          .sigma = sigma,
          .halfWidth = studentHalfWidth(freedom) * sigma * std::sqrt((freedom - 2) / freedom),
          .freedom = freedom,
          .learned = std::max(0.0, 1 - sigma / priorSigma)};
}

/// Counts what the fit's loss rejects, and measures the errors of the rest, joint angles as read.
void measureKept(const Residuals& residuals, const std::vector<WitnessResidual>& readings, CalibrationResult& result) {
  const Measurements& measurements = residuals.measurements();
  RejectedMeasurements& rejected = result.rejected;
  std::vector<double> present, kept;
  for (std::size_t i = 0; i < result.residuals.size(); ++i) {
    const BoardResidual& fitted = result.residuals[i];
    const bool isDisplaced = isMostlyOutliers(fitted);
    rejected.views += isDisplaced ? 1 : 0;
    for (Eigen::Index corner = 0; corner < fitted.weight.size() && !isDisplaced; ++corner) {
      const double distance = result.withReportedAngles[i].residual.col(corner).norm();
      const bool isRejected = fitted.weight[corner] < outlierWeight;
      present.push_back(distance);
      rejected.corners += isRejected ? 1 : 0;
      if (!isRejected) {
        kept.push_back(distance);
      }
    }
  }
  std::vector<WitnessResidual> keptReadings = readings;
  std::erase_if(keptReadings, [&](const WitnessResidual& one) {
    return std::any_of(result.doubtfulReadings.begin(), result.doubtfulReadings.end(),
                       [&](const DoubtfulReading& doubtful) {
                         return doubtful.picture == one.picture && doubtful.witness == one.witness;
                       });
  });
  rejected.readings = readings.size() - keptReadings.size();
  rejected.ofViews = countViews(measurements);
  rejected.ofCorners = measurements.cornerCount;
  rejected.ofReadings = readings.size();
  rejected.keptReadings = summarizeReadings(measurements, keptReadings);
  if (measurements.cornerCount == 0) {
    present = scaledDistances(measurements, readings, residuals.noise());
    kept = scaledDistances(measurements, keptReadings, residuals.noise());
  }
  rejected.presentPx = summarizeDistances(std::move(present)).rmsPx;
  rejected.keptPx = summarizeDistances(std::move(kept)).rmsPx;
}

/// Distances of corners and errors of other readings: from the prediction at the joint angles as read, without
/// deflections; and with the fit's deflections, at which those that disagree with the rest are listed.
void measureDistances(const Residuals& residuals, const Fit& fit, CalibrationResult& result) {
  const Measurements& measurements = residuals.measurements();
  const Residuals::State asRead = residuals.startState(result.unknowns);
  result.withReportedAngles = residuals.boardResiduals(asRead);
  const std::vector<WitnessResidual> readings = residuals.witnessResiduals(asRead);
  const ResidualSummary summary =
      summarizeDistances(collectDistances(measurements, result.withReportedAngles, readings, residuals.noise()));
  if (!std::isfinite(summary.rmsPx)) { // the fit's deflections were feasible, zero deflections are not
    throw behindCameraError();
  }
  result.rmsPx = summary.rmsPx;
  result.medianPx = summary.medianPx;
  if (measurements.witnessCount > 0) {
    result.readings = summarizeReadings(measurements, readings);
  }
  result.residuals = residuals.boardResiduals(fit.minimum.state);
  result.outliers = findOutliers(measurements, result);
  result.doubtfulReadings = findDoubtfulReadings(residuals.witnessResiduals(fit.minimum.state));
  measureKept(residuals, readings, result);
}

/// Requested physical unknowns.
struct PhysicalUnknowns {
  std::vector<std::size_t> indices; // into all unknowns
  std::vector<double> sigmas;       // of the priors
  std::vector<std::string> names, units, descriptions;
};

PhysicalUnknowns listPhysicalUnknowns(const Model& model) {
  PhysicalUnknowns result;
  const Eigen::VectorXd sigmas = model.sigmas();
  const std::vector<std::string> names = model.names(), units = model.units();
  for (const Term& term : model.terms()) {
    for (std::size_t i = 0; i < term.effect.unknowns.size() && !term.isPlacement && term.requested; ++i) {
      const std::size_t unknown = term.first + i;
      result.indices.push_back(unknown);
      result.sigmas.push_back(sigmas[eigenIndex(unknown)]);
      result.names.push_back(names[unknown]);
      result.units.push_back(units[unknown]);
      result.descriptions.push_back(describeUnknown(term, i));
    }
  }
  return result;
}

/// Covariance of the physical unknowns in units of their prior sigmas.
Eigen::MatrixXd relativeCovariance(const PhysicalUnknowns& physical, const Eigen::MatrixXd& covariance) {
  const std::size_t count = physical.indices.size();
  Eigen::MatrixXd relative(eigenIndex(count), eigenIndex(count));
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      relative(eigenIndex(i), eigenIndex(j)) =
          covariance(eigenIndex(physical.indices[i]), eigenIndex(physical.indices[j])) /
          (physical.sigmas[i] * physical.sigmas[j]);
    }
  }
  return relative;
}

/// Indices of the components of an eigenvector that are large enough to be named.
std::vector<std::size_t> largeComponents(const Eigen::VectorXd& vector) {
  constexpr double shared = 0.4; // relative to the largest component; smaller ones are not named
  const double least = shared * vector.cwiseAbs().maxCoeff();
  std::vector<std::size_t> result;
  for (Eigen::Index i = 0; i < vector.size(); ++i) {
    if (std::abs(vector[i]) >= least) {
      result.push_back(static_cast<std::size_t>(i));
    }
  }
  return result;
}

/// Weak direction along an eigenvector of the relative covariance with posterior sigma `sigma` [prior sigmas]; in
/// radians if all its named unknowns are angles.
WeakDirection describeDirection(const PhysicalUnknowns& physical, const Eigen::MatrixXd& covariance,
                                const Eigen::VectorXd& vector, double sigma) {
  WeakDirection direction{.parts = {}, .sigma = sigma, .unit = "rad", .sentence = {}};
  const std::vector<std::size_t> large = largeComponents(vector);
  std::vector<std::string> words;
  Eigen::VectorXd turn = Eigen::VectorXd::Zero(covariance.rows()); // the direction in radians
  for (const std::size_t i : large) {
    const double share = vector[eigenIndex(i)];
    direction.parts.emplace_back(physical.names[i], share);
    words.push_back(physical.descriptions[i]);
    turn[eigenIndex(physical.indices[i])] = share * physical.sigmas[i];
    if (physical.units[i] != "rad") {
      direction.unit = "prior sigmas";
    }
  }
  if (direction.unit == "rad") {
    turn.normalize();
    direction.sigma = std::sqrt(turn.dot(covariance * turn));
    for (std::size_t part = 0; part < large.size(); ++part) {
      direction.parts[part].second = turn[eigenIndex(physical.indices[large[part]])];
    }
  }
  direction.sentence =
      words.size() == 1
          ? fmt::format("these captures hardly tell {}", words.front())
          : fmt::format("{} can be traded against each other: these captures hardly tell them apart", joinWords(words));
  return direction;
}

} // namespace

CalibrationResult estimateUncertainty(const Measurements& measurements, const Model& model, const Fit& fit,
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
  result.covariance = inverse(Eigen::LLT<Eigen::MatrixXd>{linear.hessian});
  double numbers = 0;
  for (std::size_t pose = 0; pose < linear.poses.size(); ++pose) {
    result.chi2 += 2 * linear.eliminated[pose].cost;
    numbers += linear.poses[pose].freedom;
  }
  result.dof = numbers - (1 - result.covariance.diagonal().cwiseQuotient(sigmas.cwiseAbs2()).array()).sum();
  const DriverColumns none{.blocks = std::vector<std::vector<DriverColumns::Block>>(linear.poses.size())};
  const Residuals residuals{measurements, model, fit.noise, fit.loss};
  const std::vector<PoseRows> rows = residuals.rows(fit.minimum.state).value(); // at the fit's linearisation point
  const PoseMisfit misfit = testPoseMisfit({rows, none, result.unknowns, sigmas, 0}, fit.noise);
  result.misfit = std::max({1.0, misfit.chi2 / misfit.freedom, result.chi2 / std::max(1.0, result.dof)});
  result.misfitFreedom = misfit.freedom;
  result.sigmaScale = std::sqrt(result.misfit);
  result.covariance = inverse(Eigen::LLT<Eigen::MatrixXd>{temperPrecision(linear.hessian, sigmas, result.misfit)});
  measureDistances(residuals, fit, result);
  result.noiseFloorPx = noiseFloorPx(rows, fit.noise);
  const LevelSpread spread{linear, result.unknowns, sigmas, levels, result.misfit};
  for (Eigen::Index i = 0; i < sigmas.size(); ++i) {
    result.estimates.push_back(
        estimate(result.unknowns[i], spread.along(Eigen::VectorXd::Unit(sigmas.size(), i), true), sigmas[i]));
  }
  return result;
}

std::vector<WeakDirection> findWeakDirections(const Model& model, const CalibrationResult& result) {
  constexpr double wide = 0.3; // in prior sigmas; a direction with a larger posterior sigma is weak
  const PhysicalUnknowns physical = listPhysicalUnknowns(model);
  const SymmetricEigen eigen = symmetricEigen(relativeCovariance(physical, result.covariance));
  std::vector<WeakDirection> weak;
  for (Eigen::Index k = eigen.values.size() - 1; k >= 0; --k) {
    const double sigma = std::sqrt(std::max(0.0, eigen.values[k]));
    if (sigma < wide) {
      break;
    }
    weak.push_back(describeDirection(physical, result.covariance, eigen.vectors.col(k), sigma));
  }
  return weak;
}

double computeWald(const CalibrationResult& fit, const Term& term) {
  const Eigen::Index first = eigenIndex(term.first), count = eigenIndex(term.effect.unknowns.size());
  Eigen::VectorXd inSigmas(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Estimate& one = fit.estimates[static_cast<std::size_t>(first + i)];
    inSigmas[i] = one.best() / one.bestSigma();
  }
  const Eigen::MatrixXd covariance = fit.covariance.block(first, first, count, count);
  const Eigen::VectorXd scale = covariance.diagonal().cwiseSqrt().cwiseInverse();
  return inSigmas.dot((scale.asDiagonal() * covariance * scale.asDiagonal()).ldlt().solve(inSigmas));
}

} // namespace naocal
