#include "diagnosis/views/PartialResidual.hpp"

#include "estimation/DriverState.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace naocal {

namespace {

/// Correction of a joint's angle by a term of the fitted model in one picture [rad or m].
double jointPart(const FittedModel& fitted, const Term& term, std::size_t joint, std::size_t index) {
  const ImageObservation& picture = fitted.measurements.pictures[index];
  const RobotSample instant = sampleAt(fitted.measurements, fitted.model, picture, fitted.fit.unknowns);
  ModelState state = predictState(fitted.measurements, fitted.model, picture, fitted.fit.unknowns);
  const double before = state.angle(joint);
  for (const CorrectedPlace& place : placesOn(term, fitted.measurements, picture)) {
    place.correct(state, term.effect, instant, term.values(fitted.fit.unknowns));
  }
  return state.angle(joint) - before;
}

/// The motor whose angle an effect at this place corrects; absent for other places.
std::optional<std::size_t> motorOf(const Term& term, const Robot& robot) {
  const bool isJoint = term.effect.placeKind == PlaceKind::motor || term.effect.placeKind == PlaceKind::joint;
  return isJoint ? std::optional{robot.joints[term.placeIndex].motor} : std::nullopt;
}

const SingleJointCorrection* findCorrections(const ExplainedModel& explained, std::size_t motor) {
  const auto found = std::find_if(explained.left.begin(), explained.left.end(),
                                  [&](const SingleJointCorrection& joint) { return joint.motor == motor; });
  return found == explained.left.end() || found->points.empty() ? nullptr : &*found;
}

bool isDriverOf(const DriverSeries& series, const Effect& effect, std::size_t joint) {
  const auto isIt = [&](Driver kind, std::size_t at) {
    return series.kind == kind && (kind == Driver::time || series.joint == at);
  };
  return std::any_of(effect.drivers.begin(), effect.drivers.end(), [&](Driver kind) { return isIt(kind, joint); }) ||
         std::any_of(effect.remoteDrivers.begin(), effect.remoteDrivers.end(),
                     [&](const RemoteDriver& other) { return isIt(other.driver, other.joint); });
}

/// Squared linear correlation of an effect's own part with a driver.
double correlation(const std::vector<PartialResidual::Point>& points, const DriverSeries& driver) {
  Eigen::ArrayXd over(eigenIndex(points.size())), own(over.size());
  for (Eigen::Index i = 0; i < over.size(); ++i) {
    over[i] = driver.mean(points[static_cast<std::size_t>(i)].pictures);
    own[i] = points[static_cast<std::size_t>(i)].own;
  }
  over -= over.mean();
  own -= own.mean();
  const double scale = over.matrix().squaredNorm() * own.matrix().squaredNorm();
  return scale > 0 ? std::pow(over.matrix().dot(own.matrix()), 2) / scale : 0;
}

/// The driver of the effect that its own part follows most closely; null if none was recorded.
const DriverSeries* findDriver(const std::vector<PartialResidual::Point>& points, const Effect& effect,
                               std::size_t joint, const std::vector<DriverSeries>& recorded) {
  const DriverSeries* best = nullptr;
  double closest = -1;
  for (const DriverSeries& series : recorded) {
    const double how = isDriverOf(series, effect, joint) ? correlation(points, series) : -1;
    if (how > closest) {
      best = &series;
      closest = how;
    }
  }
  return best;
}

/// A joint's error over `driver`: the name and unit of both.
PartialResidual describeJointError(const Robot& robot, std::size_t motor, const DriverSeries& driver) {
  return {.error = robot.joints[motor].name,
          .over = describeDriver(driver, robot),
          .unit = robot.joints[motor].isPrismatic ? "m" : "rad",
          .overUnit = driver.unit};
}

/// Absent if the term does not turn a joint, or nothing that drives it was recorded.
std::optional<PartialResidual> computeJointErrors(const ExplainedModel& explained, const Term& term,
                                                  const std::vector<DriverSeries>& recorded) {
  const Robot& robot = explained.fitted.measurements.robot;
  const std::optional<std::size_t> motor = motorOf(term, robot);
  const SingleJointCorrection* const corrections = motor ? findCorrections(explained, *motor) : nullptr;
  if (corrections == nullptr) {
    return std::nullopt;
  }
  std::vector<PartialResidual::Point> points;
  double most = 0;
  for (const JointCorrection& correction : corrections->points) {
    double own = 0;
    for (const std::size_t picture : correction.pictures) {
      own += jointPart(explained.fitted, term, *motor, picture) / static_cast<double>(correction.pictures.size());
    }
    most = std::max(most, std::abs(own));
    points.push_back({correction.pictures, 0, own, correction.deflection, correction.sigma});
  }
  const DriverSeries* const driver = findDriver(points, term.effect, *motor, recorded);
  if (most == 0 || driver == nullptr) {
    return std::nullopt;
  }
  PartialResidual result = describeJointError(robot, *motor, *driver);
  for (PartialResidual::Point& point : points) {
    point.over = driver->mean(point.pictures);
  }
  result.points = std::move(points);
  return result;
}

/// Displacements of a pose's measurements by the estimate of a term [px].
Eigen::VectorXd displacement(const PoseRows& rows, const Term& term, const Eigen::VectorXd& unknowns) {
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(rows.byUnknowns.rows());
  for (std::size_t i = 0; i < rows.unknowns.size(); ++i) {
    const std::size_t unknown = rows.unknowns[i];
    if (unknown >= term.first && unknown < term.first + term.effect.unknowns.size()) {
      moved += rows.byUnknowns.col(eigenIndex(i)) * unknowns[eigenIndex(unknown)];
    }
  }
  return moved;
}

std::optional<PartialResidual> computeDisplacements(const ExplainedModel& explained, const Term& term) {
  const Measurements& measurements = explained.fitted.measurements;
  Noise noise = explained.candidateTests.noise();
  noise.pose = 0; // keeps pose-to-pose scatter visible
  PartialResidual result{.unit = "px", .overUnit = "px"};
  for (std::size_t index = 0; index < measurements.poses.size(); ++index) {
    PoseRows rows = explained.candidateTests.poses()[index];
    const Eigen::VectorXd moved = displacement(rows, term, explained.fitted.fit.unknowns);
    const double own = std::sqrt(2 * moved.squaredNorm() / std::max(1.0, rows.numbers));
    rows.byUnknowns = moved;
    const PoseSystem pose = systemOf(rows);
    const MarginalSystem whitened = marginalize(pose, noise, jointErrorRoot(pose, noise));
    const double information = whitened.hessian(0, 0);
    if (!(own > 0) || !(information > 0)) {
      continue; // not moved in this pose
    }
    PartialResidual::Point& point = result.points.emplace_back();
    for (const EncoderSample& reading : measurements.poses[index].readings) {
      point.pictures.insert(point.pictures.end(), reading.pictures.begin(), reading.pictures.end());
    }
    point.over = point.own = own;
    point.left = -own * whitened.unknownGradient[0] / information;
    point.sigma = own / std::sqrt(information);
  }
  return result.points.empty() ? std::nullopt : std::optional{std::move(result)};
}

/// Root mean square over the points.
template <class Value> double rmsOf(const std::vector<PartialResidual::Point>& points, const Value& value) {
  double squares = 0;
  for (const PartialResidual::Point& point : points) {
    squares += std::pow(value(point), 2);
  }
  return std::sqrt(squares / std::max<double>(1, static_cast<double>(points.size())));
}

/// A drawn curve at x, linear between its points.
double valueAt(const DriverCurve& curve, double x) {
  const auto after = std::find_if(curve.curve.begin(), curve.curve.end(), [&](const auto& one) { return one[0] >= x; });
  if (after == curve.curve.begin() || after == curve.curve.end()) {
    return after == curve.curve.end() ? curve.curve.back()[1] : (*after)[1];
  }
  const auto& before = *std::prev(after);
  return std::lerp(before[1], (*after)[1], (x - before[0]) / ((*after)[0] - before[0]));
}

} // namespace

double PartialResidual::before() const {
  return rmsOf(points, [](const Point& point) { return point.own + point.left; });
}

double PartialResidual::after() const {
  return rmsOf(points, [](const Point& point) { return point.left; });
}

std::optional<PartialResidual> computePartialResidual(const ExplainedModel& explained, const Term& term,
                                                      const std::vector<DriverSeries>& recorded) {
  auto result = computeJointErrors(explained, term, recorded);
  result = result ? std::move(result) : computeDisplacements(explained, term);
  if (result) {
    result->label = term.label();
  }
  return result;
}

std::optional<PartialResidual> computePartialResidual(const ExplainedModel& explained, const DriverCurve& curve,
                                                      const std::vector<DriverSeries>& recorded) {
  const Robot& robot = explained.fitted.measurements.robot;
  const std::optional<std::size_t> motor = curve.about.empty() ? robot.jointIndex(curve.place) : std::nullopt;
  const SingleJointCorrection* const corrections = motor ? findCorrections(explained, *motor) : nullptr;
  const auto driver = std::find_if(recorded.begin(), recorded.end(), [&](const DriverSeries& one) {
    return motor && expressionName(one, *motor) == curve.driver && (!one.motor || one.motor == motor);
  });
  if (corrections == nullptr || driver == recorded.end() || curve.curve.empty()) {
    return std::nullopt;
  }
  PartialResidual result = describeJointError(robot, *motor, *driver);
  result.label = fmt::format("{} over {}", curve.place, curve.driver);
  double sum = 0, weights = 0;
  for (const JointCorrection& correction : corrections->points) {
    const double over = driver->mean(correction.pictures), own = valueAt(curve, over);
    result.points.push_back({correction.pictures, over, own, correction.deflection, correction.sigma});
    sum += own / (correction.sigma * correction.sigma);
    weights += 1 / (correction.sigma * correction.sigma);
  }
  for (PartialResidual::Point& point : result.points) {
    point.own -= sum / weights;
    point.left -= point.own;
  }
  return result;
}

} // namespace naocal
