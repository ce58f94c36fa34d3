#include "calibration/Task.hpp"

#include "effects/Catalogue.hpp"
#include "estimation/DriverState.hpp"
#include "estimation/EffectJacobian.hpp"
#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/Statistics.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace naocal {

namespace {

/// A model and its unknowns, at which derivatives are taken.
struct LinearisedModel {
  const Measurements& measurements;
  const Model& model;
  const Eigen::VectorXd& unknowns;
};

/// A point whose place matters: what a picture's board stands for, or what a witness measures.
struct TaskPoint {
  std::size_t picture = 0, index = 0; // observation or witness of the picture
  enum class Kind { floor, inCamera, reading } kind = Kind::floor;
};

/// Shift of a point [m] (rows: its axes) per unit of each quantity of the state.
using ByQuantity = Eigen::MatrixXd;

/// First view of a board on the floor; absent if there is none.
std::optional<std::size_t> findFloorBoard(const ImageObservation& picture, const Measurements& measurements) {
  const auto found =
      std::find_if(picture.observations.begin(), picture.observations.end(),
                   [&](const BoardObservation& s) { return measurements.targets[s.view.board()].isFlat; });
  return found == picture.observations.end()
             ? std::nullopt
             : std::optional{static_cast<std::size_t>(found - picture.observations.begin())};
}

/// State of a picture with the head straight and the board 2 m ahead of the support sole.
ModelState stateAt2m(const ImageObservation& picture, const ObservationChain& view, const LinearisedModel& at) {
  const Robot& robot = at.measurements.robot;
  ModelState modelState = predictState(at.measurements, at.model, picture, at.unknowns);
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

/// A chain in one state.
struct PosedView {
  const Robot& robot;
  const ObservationChain& view;
  ModelState modelState;
  LinkPoses torsoFromLink;

  PosedView(const Robot& ofRobot, const ObservationChain& chain, ModelState state)
      : robot{ofRobot}, view{chain}, modelState{std::move(state)} {
    forwardKinematics(robot, modelState, view.links(), torsoFromLink);
  }
  PosedRobot posed() const { return {robot, modelState, torsoFromLink}; }
};

/// Shift of a point of the scene [m] per motion (omega, v): omega x point + v.
Eigen::Matrix<double, 3, 6> shiftByMotion(const Eigen::Vector3d& point) {
  Eigen::Matrix<double, 3, 6> result;
  result << 0, point.z(), -point.y(), 1, 0, 0, //
      -point.z(), 0, point.x(), 0, 1, 0,       //
      point.y(), -point.x(), 0, 0, 0, 1;
  return result;
}

/// Motion (omega, v) of the scene seen from the chain's eye, per unit of every quantity that moves it.
Eigen::MatrixXd motionByQuantity(const PosedView& posed, const CameraFrames& attitude, const StateLayout& layout) {
  std::vector<std::size_t> wanted;
  for (std::size_t quantity = 0; quantity < layout.size(); ++quantity) {
    const auto board = layout.boardOf(quantity);
    if (!layout.isOfInstrument(quantity) && !posed.view.extraIndex(quantity) &&
        (!board || *board == posed.view.board())) {
      wanted.push_back(quantity);
    }
  }
  Eigen::MatrixXd columns(6, eigenIndex(wanted.size()));
  posed.view.fillMotionColumns(posed.posed(), attitude, wanted, {}, columns);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(6, eigenIndex(layout.size()));
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    result.col(eigenIndex(wanted[i])) = columns.col(eigenIndex(i));
  }
  return result;
}

/// A point of the board as a corner to project.
CornerBlocks cornerAt(const Eigen::Vector3d& point) {
  return {CornerBlock{
      .x = Double4{} + point.x(), .y = Double4{} + point.y(), .z = Double4{} + point.z(), .present = {1, 1, 1, 1}}};
}

/// Shift of a point across its ray [m] that moves it in the picture as a unit of each number of the lens does. `point`:
/// in the board.
Eigen::Matrix<double, 3, 9> shiftByLens(const PosedView& posed, const CameraFrames& attitude,
                                        const Eigen::Vector3d& point) {
  const CornerBlocks corners = cornerAt(point);
  ProjectedBlocks projected;
  Eigen::Matrix<double, 3, 9> result = Eigen::Matrix<double, 3, 9>::Zero();
  if (posed.view.project(attitude, posed.modelState, corners, projected)) {
    const double depth = (attitude.opticalFromBoard * point).z();
    const auto lens = posed.modelState.lens();
    for (std::size_t i = 0; i < lensCount; ++i) {
      const CornerShift shift =
          ObservationChain::shiftByExtra(i, attitude, posed.modelState, corners.front(), projected.front());
      result.col(eigenIndex(i)) << depth * shift.u[0] / lens[0], depth * shift.v[0] / lens[1], 0;
    }
  }
  return result;
}

/// Whether a picture of this camera shows the point: elsewhere its lens says nothing.
bool isInPicture(const ImageObservation& picture, const PosedView& posed, const CameraFrames& attitude,
                 const Measurements& measurements) {
  const auto& camera = measurements.setOf(picture).cameras.at(measurements.captureOf(picture).camera);
  ProjectedBlocks projected;
  return attitude.opticalFromBoard.translation.z() > 0.1 &&
         posed.view.project(attitude, posed.modelState, cornerAt(Eigen::Vector3d::Zero()), projected) &&
         projected.front().u[0] >= 0 && projected.front().u[0] <= camera.width && projected.front().v[0] >= 0 &&
         projected.front().v[0] <= camera.height;
}

/// A floor point 2 m ahead, in the floor's axes: the ray is fixed and the floor moves. Not by placements and boards,
/// and by the lens only where the picture shows the point. Absent if it lies behind the camera.
std::optional<ByQuantity> shiftOnFloor(const TaskPoint& point, const LinearisedModel& at) {
  const ImageObservation& picture = at.measurements.pictures[point.picture];
  const ObservationChain& view = picture.observations[point.index].view;
  const PosedView posed{at.measurements.robot, view, stateAt2m(picture, view, at)};
  const CameraFrames attitude = view.cameraFrames(posed.posed());
  const Eigen::Vector3d place = attitude.opticalFromBoard.translation,
                        normal = attitude.opticalFromWorld.rotation.col(2);
  if (place.z() < 0.1) { // [m]
    return std::nullopt;
  }
  const StateLayout& layout = at.measurements.quantities;
  Eigen::MatrixXd scene = shiftByMotion(place) * motionByQuantity(posed, attitude, layout);
  const auto first = eigenIndex(layout.lens());
  scene.middleCols(first, eigenIndex(layout.linkStep(0)) - first).setZero();
  if (isInPicture(picture, posed, attitude, at.measurements)) {
    scene.middleCols<9>(first) = shiftByLens(posed, attitude, Eigen::Vector3d::Zero());
  }
  const Eigen::MatrixXd shift = place * (normal.transpose() * scene) / place.dot(normal) - scene;
  return (attitude.opticalFromWorld.rotation.transpose() * shift).topRows<2>();
}

/// Middle of a board's corners, in the board.
Eigen::Vector3d middleOf(const Board& board) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : board.points) {
    sum += point;
  }
  return sum / std::max<double>(1, static_cast<double>(board.points.size()));
}

/// A board's middle in the camera's frame. Absent if it lies behind the camera.
std::optional<ByQuantity> shiftInCamera(const TaskPoint& point, const LinearisedModel& at) {
  const ImageObservation& picture = at.measurements.pictures[point.picture];
  const ObservationChain& view = picture.observations[point.index].view;
  const PosedView posed{at.measurements.robot, view, predictState(at.measurements, at.model, picture, at.unknowns)};
  const CameraFrames attitude = view.cameraFrames(posed.posed());
  const Eigen::Vector3d inBoard = middleOf(at.measurements.targets[view.board()].board),
                        middle = attitude.opticalFromBoard * inBoard;
  if (middle.z() < 0.1) { // [m]
    return std::nullopt;
  }
  const StateLayout& layout = at.measurements.quantities;
  ByQuantity result = shiftByMotion(middle) * motionByQuantity(posed, attitude, layout);
  result.middleCols<9>(eigenIndex(layout.lens())) = shiftByLens(posed, attitude, inBoard);
  return result;
}

/// The rows of a reading that are in metres, if any.
const Witness::Part* findMetres(const Measurements& measurements, const WitnessObservation& observation) {
  const std::vector<Witness::Part>& parts = observation.witness->parts();
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const Witness::Part& part) {
    return measurements.levels[part.level].unit == ReadingLevel::Unit::metres;
  });
  return observation.view && found != parts.end() ? &*found : nullptr;
}

/// What an instrument measures, in its frame.
ByQuantity shiftOfReading(const TaskPoint& point, const LinearisedModel& at) {
  const ImageObservation& picture = at.measurements.pictures[point.picture];
  const WitnessObservation& observation = picture.witnesses[point.index];
  const PosedView posed{at.measurements.robot, *observation.view,
                        predictState(at.measurements, at.model, picture, at.unknowns)};
  const CameraFrames frames = posed.view.pathFrames(posed.posed());
  const WitnessRows rows = observation.witness->compare(frames.opticalFromWorld, posed.modelState);
  const StateLayout& layout = at.measurements.quantities;
  Eigen::MatrixXd motion = motionByQuantity(posed, frames, layout);
  const auto boards = eigenIndex(layout.board(0));
  motion.middleCols(boards, eigenIndex(layout.tracker(0)) - boards).setZero();
  const Witness::Part& part = *findMetres(at.measurements, observation);
  ByQuantity result = rows.byMotion.middleRows(part.first, part.count) * motion;
  const std::vector<std::size_t>& own = observation.witness->own();
  for (std::size_t i = 0; i < own.size(); ++i) {
    result.col(eigenIndex(own[i])) += rows.byOwn.col(eigenIndex(i)).segment(part.first, part.count);
  }
  return result;
}

std::optional<ByQuantity> shiftOf(const TaskPoint& point, const LinearisedModel& at) {
  switch (point.kind) {
  case TaskPoint::Kind::floor:
    return shiftOnFloor(point, at);
  case TaskPoint::Kind::inCamera:
    return shiftInCamera(point, at);
  case TaskPoint::Kind::reading:
    return shiftOfReading(point, at);
  }
  return std::nullopt;
}

/// The same per unit of each unknown.
Eigen::MatrixXd byUnknowns(const ByQuantity& shift, const TaskPoint& point, const LinearisedModel& at) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(shift.rows(), at.unknowns.size());
  for (const StateDerivative& slope :
       evaluateJacobian(at.measurements, at.model, at.measurements.pictures[point.picture], at.unknowns)) {
    result.col(eigenIndex(slope.unknown)) += slope.value * shift.col(eigenIndex(slope.quantity));
  }
  return result;
}

/// The same per unit of each column of the joints' curves, as they deflect the joints in the point's picture.
Eigen::MatrixXd byCurves(const ByQuantity& shift, const TaskPoint& point, const Measurements& measurements,
                         const WideModel& wide) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(shift.rows(), wide.map().count);
  const std::size_t pose = posesOfPictures(measurements)[point.picture];
  const std::vector<EncoderSample>& readings = measurements.poses[pose].readings;
  const auto reading = std::find_if(readings.begin(), readings.end(), [&](const EncoderSample& one) {
    return std::find(one.pictures.begin(), one.pictures.end(), point.picture) != one.pictures.end();
  });
  if (reading == readings.end()) {
    return result;
  }
  const PoseRows& rows = wide.poses()[pose];
  for (const DriverColumns::Block& block : wide.map().blocks[pose]) {
    for (Eigen::Index i = 0; i < block.values.rows(); ++i) {
      const auto deflection = static_cast<std::size_t>(block.firstDeflection + i);
      const std::size_t joint = rows.joints[deflection];
      if (reading->encoderError[joint] == rows.errors[deflection]) {
        result.middleCols(block.firstColumn, block.values.cols()) +=
            shift.col(eigenIndex(measurements.quantities.angle(joint))) * block.values.row(i);
      }
    }
  }
  return result;
}

LinearisedModel linearised(const FittedModel& fitted) {
  return {fitted.measurements, fitted.model, fitted.fit.unknowns};
}

/// All points of a kind of task.
std::vector<TaskPoint> listFloorPoints(const Measurements& measurements) {
  std::vector<TaskPoint> result;
  for (std::size_t i = 0; i < measurements.pictures.size(); ++i) {
    if (const auto board = findFloorBoard(measurements.pictures[i], measurements)) {
      result.push_back({i, *board, TaskPoint::Kind::floor});
    }
  }
  return result;
}

std::vector<TaskPoint> listToolPoints(const Measurements& measurements) {
  std::vector<TaskPoint> result;
  for (std::size_t i = 0; i < measurements.pictures.size(); ++i) {
    const ImageObservation& picture = measurements.pictures[i];
    for (std::size_t k = 0; k < picture.witnesses.size(); ++k) {
      if (findMetres(measurements, picture.witnesses[k])) {
        result.push_back({i, k, TaskPoint::Kind::reading});
      }
    }
    for (std::size_t k = 0; k < picture.observations.size(); ++k) {
      result.push_back({i, k, TaskPoint::Kind::inCamera});
    }
  }
  return result;
}

/// The point whose variance under the fit has this rank among all, from 0 (least) to 1, and that variance [m^2].
std::optional<std::pair<double, TaskPoint>> selectPoint(const std::vector<TaskPoint>& points, const FittedModel& fitted,
                                                        double rank) {
  std::vector<std::pair<double, TaskPoint>> all;
  for (const TaskPoint& point : points) {
    if (const auto shift = shiftOf(point, linearised(fitted))) {
      const Eigen::MatrixXd slopes = byUnknowns(*shift, point, linearised(fitted));
      all.emplace_back((slopes * fitted.fit.covariance).cwiseProduct(slopes).sum(), point);
    }
  }
  if (all.empty()) {
    return std::nullopt;
  }
  const auto chosen = all.begin() + static_cast<std::ptrdiff_t>(rank * static_cast<double>(all.size() - 1) + 0.5);
  std::nth_element(all.begin(), chosen, all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return *chosen;
}

/// The point by which a result is judged, with what it is called. Absent if no point is measured.
std::optional<std::pair<const char*, TaskPoint>> findTaskPoint(const FittedModel& fitted) {
  if (const auto floor = selectPoint(listFloorPoints(fitted.measurements), fitted, 0.5)) {
    return std::pair{"ball at 2 m", floor->second};
  }
  if (const auto tool = selectPoint(listToolPoints(fitted.measurements), fitted, 1)) {
    return std::pair{"tool", tool->second};
  }
  return std::nullopt;
}

/// Largest bound at which a result is usable [m].
double toleranceOf(const TaskPoint& point, const FittedModel& fitted) {
  constexpr double onFloor = 0.05, noiseFloors = 10;
  constexpr double atTool = 0.005; // at most: noise that is estimated where a cause is missing holds its misfit, too
  const ImageObservation& picture = fitted.measurements.pictures[point.picture];
  switch (point.kind) {
  case TaskPoint::Kind::floor:
    return onFloor;
  case TaskPoint::Kind::reading: { // a corner has two axes, a point three
    const Witness::Part& part = *findMetres(fitted.measurements, picture.witnesses[point.index]);
    return std::min(atTool, noiseFloors * fitted.fit.noiseFloorPx * std::sqrt(1.5) / fitted.fit.noise.pixel *
                                sigmaOf(fitted.measurements, fitted.fit.noise, part.level));
  }
  case TaskPoint::Kind::inCamera: {
    const PosedView posed{fitted.measurements.robot, picture.observations[point.index].view,
                          predictState(fitted.measurements, fitted.model, picture, fitted.fit.unknowns)};
    return std::min(atTool, noiseFloors * fitted.fit.noiseFloorPx *
                                posed.view.cameraFrames(posed.posed()).opticalFromBoard.translation.norm() /
                                posed.modelState.lens()[0]);
  }
  }
  return 0;
}

/// Shifts of the task's point: by the own unknowns and by all columns of the widest explanation, and by the fitted
/// values, which are what a robot is given.
struct TaskShifts {
  Eigen::MatrixXd own, columns;
  Eigen::VectorXd given;
};

std::optional<TaskShifts> shiftsUnder(const WideModel& wide, const TaskPoint& point, const FittedModel& fitted) {
  const LinearisedModel at{fitted.measurements, wide.extended(), wide.unknowns()};
  const auto shift = shiftOf(point, at);
  if (!shift) {
    return std::nullopt;
  }
  const Eigen::MatrixXd slopes = byUnknowns(*shift, point, at),
                        curves = byCurves(*shift, point, fitted.measurements, wide);
  TaskShifts result{slopes.leftCols(wide.problem().ownCount()),
                    {},
                    slopes * mapParameters(fitted.model, fitted.fit.unknowns, wide.extended())};
  result.columns.resize(slopes.rows(), wide.problem().plausible.size());
  result.columns << slopes.rightCols(wide.problem().candidates), curves;
  return result;
}

/// Distance from a value to the further end of a bound.
double reach(double value, const std::array<double, 2>& bound) {
  return std::max(bound[1] - value, value - bound[0]);
}

/// The joint offset with the largest bias, relative to its prior.
std::optional<Undetectable> worstOffset(const FittedModel& fitted, const ModelAverage& average) {
  std::optional<Undetectable> result;
  double most = 0;
  for (const Term& term : fitted.model.terms()) {
    if (term.effect.name == effectName::jointOffset && term.requested) {
      const auto found = average.worstBiasOf(eigenIndex(term.first));
      if (found && found->second / term.effect.unknowns.front().sigma > most) {
        most = found->second / term.effect.unknowns.front().sigma;
        result = Undetectable{found->first, term.placeName, found->second, term.effect.unknowns.front().unit};
      }
    }
  }
  return result;
}

} // namespace

void fillTask(const FittedModel& fitted, const ModelAverage* average, std::optional<double> tolerance,
              CalibrationResult& result) {
  const auto found = findTaskPoint(fitted);
  const auto shifts = found && average ? shiftsUnder(average->wide(), found->second, fitted) : std::nullopt;
  if (average) {
    result.undetectable = shifts ? average->worstBias(shifts->own, shifts->columns) : worstOffset(fitted, *average);
  }
  if (!found || (average && !shifts)) {
    if (tolerance) {
      throw InputError{
          found ? "a tolerance was given, but the likeliest explanation puts the point that it is for behind "
                  "its camera"
                : "a tolerance was given, but these captures measure no point to hold against it: expected "
                  "a board, a marker or a place that is touched"};
    }
    return;
  }
  Task task{.what = found->first,
            .tolerance = tolerance.value_or(toleranceOf(found->second, fitted)),
            .isGiven = tolerance.has_value()};
  const Eigen::MatrixXd slopes =
      byUnknowns(*shiftOf(found->second, linearised(fitted)), found->second, linearised(fitted));
  Eigen::VectorXd given = shifts ? shifts->given : Eigen::VectorXd{};
  for (const Term& term : fitted.model.terms()) { // an added effect that the likeliest explanation replaces
    if (shifts && !average->wide().extended().find(term.label())) {
      const auto first = eigenIndex(term.first), count = eigenIndex(term.effect.unknowns.size());
      given += slopes.middleCols(first, count) * fitted.fit.unknowns.segment(first, count);
    }
  }
  const double multiple = studentQuantile(0.99975, fitted.fit.misfit > 1 ? fitted.fit.misfitFreedom : 1e6);
  double variance = 0, squares = 0;
  for (Eigen::Index axis = 0; axis < slopes.rows(); ++axis) {
    if (shifts) {
      const Averaged averaged = average->along(slopes.row(axis), shifts->own.row(axis), shifts->columns.row(axis));
      variance += std::pow(averaged.sigma, 2) + std::pow(averaged.value - given[axis], 2);
      squares += std::pow(reach(given[axis], averaged.bound), 2);
    } else {
      const double one = slopes.row(axis) * fitted.fit.covariance * slopes.row(axis).transpose();
      variance += one;
      squares += multiple * multiple * one;
    }
  }
  task.sigma = std::sqrt(variance);
  task.bound = std::sqrt(squares);
  result.task = std::move(task);
}

} // namespace naocal
