#include "calibration/Uncertainty.hpp"

#include "calibration/Outliers.hpp"
#include "calibration/ReadingErrors.hpp"
#include "calibration/result/Wording.hpp"
#include "estimation/DriverState.hpp"
#include "inference/NoiseLevels.hpp"
#include "inference/PoseMisfit.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/Parallel.hpp"
#include "math/Statistics.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace naocal {

namespace {

/// First view of a board on the floor; null if there is none.
const BoardObservation* findFloorBoard(const ImageObservation& picture, const Measurements& measurements) {
  const auto found =
      std::find_if(picture.observations.begin(), picture.observations.end(),
                   [&](const BoardObservation& s) { return measurements.targets[s.view.board()].isFlat; });
  return found == picture.observations.end() ? nullptr : &*found;
}

/// State of a picture with the head straight and the board 2 m ahead of the support sole.
ModelState stateAt2m(const ImageObservation& picture, const ObservationChain& view, const FittedModel& fitted) {
  const Robot& robot = fitted.measurements.robot;
  ModelState modelState = predictState(fitted.measurements, fitted.model, picture, fitted.fit.unknowns);
  modelState.worldFromSupport().setZero();
  modelState.boardPlacement(view.board()) << 2, 0, 0, 0, 0, 0;
  const auto towardsHead = ancestorLinks(robot, {robot.cameras[picture.camera].link});
  for (std::size_t joint : view.joints()) {
    if (std::find(towardsHead.begin(), towardsHead.end(), robot.joints[joint].link) != towardsHead.end()) {
      modelState.angle(joint) = 0;
    }
  }
  return modelState;
}

/// Derivatives of a picture's state apart from lenses, placements and boards.
std::vector<StateDerivative> physicalDerivatives(const ImageObservation& picture, const FittedModel& fitted) {
  std::vector<StateDerivative> result =
      evaluateJacobian(fitted.measurements, fitted.model, picture, fitted.fit.unknowns);
  std::erase_if(result,
                [&](const StateDerivative& slope) { return slope.quantity >= fitted.measurements.quantities.lens(); });
  return result;
}

/// Shift of a floor point [m], in the floor's axes, per motion (omega, v) of the scene in the optical frame: the ray is
/// fixed and the floor moves.
Eigen::Vector2d shiftOnFloor(const CameraFrames& attitude, const Eigen::Matrix<double, 6, 1>& scene) {
  const Eigen::Vector3d point = attitude.opticalFromBoard.translation;
  const Eigen::Vector3d normal = attitude.opticalFromWorld.rotation.col(2);
  const Eigen::Vector3d omega = scene.head<3>();
  const Eigen::Vector3d motion = omega.cross(point) + scene.tail<3>();
  const Eigen::Vector3d shift = point * (motion.dot(normal) / point.dot(normal)) - motion;
  return (attitude.opticalFromWorld.rotation.transpose() * shift).head<2>();
}

/// Error with the legs as in one picture [m]; absent if it shows no floor board or the point lies behind the camera.
std::optional<double> predictErrorIn(const ImageObservation& picture, const FittedModel& fitted) {
  const BoardObservation* const observation = findFloorBoard(picture, fitted.measurements);
  if (!observation) {
    return std::nullopt;
  }
  const ObservationChain& view = observation->view;
  const ModelState modelState = stateAt2m(picture, view, fitted);
  LinkPoses torsoFromLink;
  forwardKinematics(fitted.measurements.robot, modelState, view.links(), torsoFromLink);
  const CameraFrames attitude = view.cameraFrames({fitted.measurements.robot, modelState, torsoFromLink});
  if (attitude.opticalFromBoard.translation.z() < 0.1) {
    return std::nullopt;
  }
  const std::vector<StateDerivative> slopes = physicalDerivatives(picture, fitted);
  std::vector<std::size_t> quantities;
  for (const StateDerivative& slope : slopes) {
    quantities.push_back(slope.quantity);
  }
  Eigen::MatrixXd columns(6, eigenIndex(quantities.size()));
  view.fillMotionColumns({fitted.measurements.robot, modelState, torsoFromLink}, attitude, quantities, {}, columns);
  Eigen::MatrixXd slip = Eigen::MatrixXd::Zero(2, fitted.fit.unknowns.size());
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    slip.col(eigenIndex(slopes[i].unknown)) += slopes[i].value * shiftOnFloor(attitude, columns.col(eigenIndex(i)));
  }
  return std::sqrt((slip * fitted.fit.covariance * slip.transpose()).trace());
}

Eigen::MatrixXd inverse(const Eigen::MatrixXd& information) {
  return information.ldlt().solve(Eigen::MatrixXd::Identity(information.rows(), information.cols()));
}

/// Variance of each unknown averaged over the possible noise levels, and its spread over them.
struct Spread {
  Eigen::VectorXd variance;       // mean over levels of the variance plus the squared shift of the estimate
  Eigen::VectorXd relativeSpread; // Var(variance) / variance^2
};

/// `moves`: whether to include the shift of the estimate.
Spread spreadOver(const Residuals::Linear& linear, const Eigen::VectorXd& unknowns, const Eigen::VectorXd& sigmas,
                  const std::vector<NoiseLevels::Level>& levels, double misfit, bool moves) {
  Spread result{Eigen::VectorXd::Zero(sigmas.size()), Eigen::VectorXd::Zero(sigmas.size())};
  for (const NoiseLevels::Level& level : levels) {
    const LinearMinimum there = solveLinearized(linear, unknowns, sigmas, level.noise);
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

/// A normal distribution of uncertain variance, as the Student's t of equal variance and kurtosis:
/// nu = 4 + 2 / (relative variance of the variance).
Estimate estimate(double value, double variance, double relativeSpread, double priorSigma) {
  const double freedom = std::min(4 + 2 / std::max(relativeSpread, 1e-9), 1e6);
  const double sigma = std::sqrt(variance);
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
    for (Eigen::Index corner = 0; corner < fitted.weight.size() && !isMostlyOutliers(fitted); ++corner) {
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

double predictFloorErrorAt2m(const FittedModel& fitted) {
  std::vector<double> errors;
  for (const ImageObservation& picture : fitted.measurements.pictures) {
    if (const auto error = predictErrorIn(picture, fitted)) {
      errors.push_back(*error);
    }
  }
  if (errors.empty()) {
    return 0;
  }
  std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2), errors.end());
  return errors[errors.size() / 2];
}

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
  result.covariance = inverse(linear.hessian);
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
  result.covariance *= result.misfit;
  measureDistances(residuals, fit, result);
  result.noiseFloorPx = noiseFloorPx(rows, fit.noise);
  const Spread spread = spreadOver(linear, result.unknowns, sigmas, levelsOf(levels), result.misfit, true);
  for (Eigen::Index i = 0; i < sigmas.size(); ++i) {
    result.estimates.push_back(estimate(result.unknowns[i], spread.variance[i], spread.relativeSpread[i], sigmas[i]));
  }
  return result;
}

Eigen::VectorXd computeLevelWidening(const Residuals::Linear& linear, const Eigen::VectorXd& sigmas,
                                     const NoiseLevels& levels) {
  const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(sigmas.size());
  const Eigen::VectorXd variance = solveLinearized(linear, nothing, sigmas, levels.noise).covariance.diagonal();
  const Spread spread = spreadOver(linear, nothing, sigmas, levelsOf(levels), 1, false);
  Eigen::VectorXd result(sigmas.size());
  for (Eigen::Index i = 0; i < sigmas.size(); ++i) {
    const Estimate wide = estimate(0, spread.variance[i], spread.relativeSpread[i], sigmas[i]);
    result[i] = wide.halfWidth / (1.96 * std::sqrt(variance[i]));
  }
  return result;
}

LinearMinimum solveLinearized(const Residuals::Linear& linear, const Eigen::VectorXd& unknowns,
                              const Eigen::VectorXd& sigmas, const Noise& noise) {
  const Eigen::VectorXd information = sigmas.cwiseAbs2().cwiseInverse();
  Eigen::MatrixXd hessian = information.asDiagonal();
  Eigen::VectorXd gradient = information.cwiseProduct(unknowns);
  std::vector<MarginalSystem> parts(linear.poses.size());
  parallelFor(parts.size(), [&](std::size_t i) {
    marginalize(linear.poses[i], noise, jointErrorRoot(linear.poses[i], noise), parts[i]);
  });
  for (std::size_t pose = 0; pose < parts.size(); ++pose) {
    const std::vector<std::size_t>& seen = linear.poses[pose].unknowns;
    gradient(seen) += parts[pose].unknownGradient;
    hessian(seen, seen) += parts[pose].hessian;
  }
  const Eigen::LLT<Eigen::MatrixXd> factor{hessian};
  return {-factor.solve(gradient), factor.solve(Eigen::MatrixXd::Identity(hessian.rows(), hessian.cols()))};
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

} // namespace naocal
