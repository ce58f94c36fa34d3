#include "estimation/Residuals.hpp"

#include "estimation/Marginalization.hpp"
#include "estimation/NormalEquations.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/Parallel.hpp"
#include "measurements/FloorContact.hpp"
#include "measurements/Measurements.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <limits>
#include <map>
#include <utility>

namespace naocal {

/// Thread-local buffers of an evaluation: allocating them takes as long as projecting the corners.
struct Residuals::Workspace {
  static Workspace& threadWorkspace(const Measurements& measurements) {
    static thread_local Workspace work;
    work.boards.resize(measurements.targets.size());
    work.cost = 0;
    work.drivenPicture = nullptr;
    return work;
  }

  /// Cached, since most boards keep their placement from picture to picture.
  const RigidTransform& linkFromBoard(std::size_t board) {
    if (boards[board].placement != modelState.boardPlacement(board)) {
      boards[board] = {modelState.boardPlacement(board), transformFromPlacement(modelState.boardPlacement(board))};
    }
    return boards[board].linkFromBoard;
  }

  /// Cached, since pictures of one reading share angles, torques and centre of mass.
  void drive(const Measurements& measurements, const Model& model, const ImageObservation& picture,
             const Eigen::VectorXd& unknowns) {
    DriverState& driven = scratch.driven;
    const ImageObservation* const last = std::exchange(drivenPicture, &picture);
    if (!last || last->instant.q != picture.instant.q || last->instant.supportFoot != picture.instant.supportFoot ||
        picture.instant.supportFoot == SupportFoot::both) {
      driven = computeDrivers(measurements, model, picture, unknowns);
      return;
    }
    RobotSample instant = picture.instant;
    instant.q.swap(driven.instant.q);
    instant.torque.swap(driven.instant.torque);
    instant.torqueGrowth.swap(driven.instant.torqueGrowth);
    instant.lateralTorque.swap(driven.instant.lateralTorque);
    instant.com = driven.instant.com;
    driven.instant = std::move(instant);
  }

  /// Adds a group's sums to those of its pose.
  void add(const ImageNormalEquations::Square& gram, const ImageNormalEquations::Column& gradient,
           const Eigen::MatrixXd& by, const PreparedImage::Group& group) {
    if (wantsRows) {
      rows.add(gram, gradient, by, group, slopes);
    } else {
      sums.add(gram, gradient, by, group, slopes);
    }
  }

  struct PlacedBoard {
    Eigen::Matrix<double, 6, 1> placement = Eigen::Matrix<double, 6, 1>::Zero();
    RigidTransform linkFromBoard;
  };
  ModelState modelState{StateLayout{0, 0, 0}};
  std::vector<PlacedBoard> boards;
  LinkPoses torsoFromLink;
  ProjectedBlocks projected;
  std::vector<CornerShift> extraShifts;
  ImageNormalEquations corners;
  Eigen::MatrixXd motion;
  NormalEquations sums; // of a pose, or
  RowEquations rows;    // of a pose
  bool wantsRows = false;
  double cost = 0;                                 // sum of rho
  const ImageObservation* drivenPicture = nullptr; // the picture that `scratch.driven` belongs to
  EffectJacobian::Scratch scratch;
  std::vector<double> varyingSlopes;
  const double* slopes = nullptr; // slope values of the picture
};

/// Floor contact: height and tilt of another sole over the floor are zero with sigmas `FloorContact`. In units of
/// pixels, like all sums.
void Residuals::addFloorContact(const ObservationChain& sole, const PreparedImage::Group& group, Workspace& work,
                                PosePart& part) const {
  const CameraFrames attitude = sole.pathFrames({measurements_.robot, work.modelState, work.torsoFromLink});
  const Eigen::Vector3d normal = attitude.opticalFromWorld.rotation.col(2);
  const Eigen::Vector3d scale =
      noise_.pixel * Eigen::Vector3d{1 / FloorContact::height, 1 / FloorContact::tilt, 1 / FloorContact::tilt};
  const Eigen::Matrix<double, 3, 6> byMotion = noise_.pixel * floorContactJacobian(normal);
  const Eigen::Vector3d residual =
      scale.cwiseProduct(Eigen::Vector3d{-normal.dot(attitude.opticalFromWorld.translation), normal.x(), normal.y()});
  work.motion.resize(6, eigenIndex(group.quantities.size()));
  sole.fillMotionColumns({measurements_.robot, work.modelState, work.torsoFromLink}, attitude, group.quantities, {},
                         work.motion);
  work.add(byMotion.transpose() * byMotion, byMotion.transpose() * residual, work.motion, group);
  work.cost += residual.squaredNorm() / (noise_.pixel * noise_.pixel);
  part.squares += residual.squaredNorm();
  part.numbers += 3;
  part.freedom += 3;
}

/// `frames`: of its chain, where it has one; "optical" is the link.
WitnessRows Residuals::compareWitness(const WitnessObservation& observation, const Workspace& work,
                                      std::optional<CameraFrames>& frames) const {
  if (observation.view) {
    frames = observation.view->pathFrames({measurements_.robot, work.modelState, work.torsoFromLink});
  }
  return observation.witness->compare(frames ? frames->opticalFromWorld : RigidTransform{}, work.modelState);
}

/// Loss of one part of a reading, by the length of its error over sigma. What the robot takes no part in, a known
/// distance, is never doubted: it tells the scale.
Loss::Value Residuals::lossOf(const WitnessObservation& observation, const Eigen::Ref<const Eigen::VectorXd>& residual,
                              const Witness::Part& part) const {
  const double sigma = sigmaOf(measurements_, noise_, part.level);
  const double squares = residual.segment(part.first, part.count).squaredNorm() / (sigma * sigma);
  return observation.view ? loss_(squares) : Loss::Value{squares, 1};
}

/// A witness: its rows over the sigma of their level, in units of pixels, like all sums. Each part has the loss of its
/// own distance.
void Residuals::addWitness(const WitnessObservation& observation, const PreparedImage::Group& group, Workspace& work,
                           PosePart& part) const {
  std::optional<CameraFrames> frames;
  WitnessRows rows = compareWitness(observation, work, frames);
  for (const Witness::Part& each : observation.witness->parts()) {
    const double sigma = sigmaOf(measurements_, noise_, each.level);
    const auto [rho, weight] = lossOf(observation, rows.residual, each);
    const double scale = std::sqrt(weight) * noise_.pixel / sigma;
    rows.residual.segment(each.first, each.count) *= scale;
    rows.byMotion.middleRows(each.first, each.count) *= scale;
    rows.byOwn.middleRows(each.first, each.count) *= scale;
    work.cost += rho;
    part.numbers += static_cast<double>(each.count);
    part.freedom += weight > 0 ? static_cast<double>(each.count) : 0;
  }
  const std::vector<std::size_t>& own = observation.witness->own();
  const Eigen::Index width = 6 + eigenIndex(own.size());
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, WitnessRows::most, ImageNormalEquations::mostOfAll> all(
      rows.residual.size(), width);
  all << rows.byMotion, rows.byOwn;
  work.motion.resize(width, eigenIndex(group.quantities.size()));
  if (observation.view) {
    observation.view->fillMotionColumns({measurements_.robot, work.modelState, work.torsoFromLink}, *frames,
                                        group.quantities, {}, work.motion);
  } else {
    work.motion.setZero();
  }
  for (std::size_t i = 0; i < group.quantities.size(); ++i) {
    const auto found = std::find(own.begin(), own.end(), group.quantities[i]);
    if (found != own.end()) {
      work.motion(6 + (found - own.begin()), eigenIndex(i)) = 1;
    }
  }
  work.add(all.transpose() * all, all.transpose() * rows.residual, work.motion, group);
  part.squares += rows.residual.squaredNorm();
}

/// IMU: the floor normal in the torso equals the one measured, with sigma `ImuNoise::angle`:
///   n_imu = (Ry(angleY) Rx(angleX) Ry(pitch) Rx(roll))^T z, roll and pitch the unit's tilt
/// Uses the two horizontal components; d(n) = omega x n.
void Residuals::addImuReading(const ImageObservation& picture, const PreparedImage& prepared, Workspace& work,
                              PosePart& part) const {
  const ObservationChain& torso = *prepared.torso;
  const StateLayout& quantities = measurements_.quantities;
  const CameraFrames attitude = torso.pathFrames({measurements_.robot, work.modelState, work.torsoFromLink});
  const Eigen::Vector3d normal = attitude.opticalFromWorld.rotation.col(2);
  const double roll = work.modelState.imuTilt()[0], pitch = work.modelState.imuTilt()[1];
  const Eigen::Vector2d reading = picture.instant.imu;
  const Eigen::Vector3d byUnit = (rotationY(reading.y()) * rotationX(reading.x())).row(2); // in the IMU frame
  const Eigen::Vector3d pitched = rotationY(-pitch) * byUnit, told = rotationX(-roll) * pitched;
  const double scale = noise_.pixel / ImuNoise::angle;

  Eigen::Matrix<double, 2, 8> byMotion = Eigen::Matrix<double, 2, 8>::Zero();
  byMotion.leftCols<3>() = -crossMatrix(normal).topRows<2>();
  byMotion.col(6) = Eigen::Vector3d::UnitX().cross(told).head<2>();
  byMotion.col(7) = (rotationX(-roll) * Eigen::Vector3d::UnitY().cross(pitched)).head<2>();
  byMotion *= scale;
  const Eigen::Vector2d residual = scale * (normal - told).head<2>();
  work.motion.resize(8, eigenIndex(prepared.imu.quantities.size()));
  torso.fillMotionColumns({measurements_.robot, work.modelState, work.torsoFromLink}, attitude, prepared.imu.quantities,
                          {}, work.motion);
  for (std::size_t i = 0; i < prepared.imu.quantities.size(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      work.motion(eigenIndex(6 + k), eigenIndex(i)) = prepared.imu.quantities[i] == quantities.imuTilt() + k ? 1 : 0;
    }
  }
  work.add(byMotion.transpose() * byMotion, byMotion.transpose() * residual, work.motion, prepared.imu);
  work.cost += residual.squaredNorm() / (noise_.pixel * noise_.pixel);
  part.squares += residual.squaredNorm();
  part.numbers += 2;
  part.freedom += 2;
}

namespace {

/// The chain from the torso to the floor, if the IMU tilt is an unknown and a reading was recorded.
std::optional<ObservationChain> torsoOverFloor(const Measurements& measurements, const Model& model,
                                               const ImageObservation& picture) {
  const bool wanted = std::any_of(model.terms().begin(), model.terms().end(),
                                  [](const Term& term) { return term.effect.name == "imuTilt"; });
  const bool onFloor =
      std::any_of(picture.observations.begin(), picture.observations.end(), [&](const BoardObservation& observation) {
        return measurements.targets[observation.view.board()].inWorld;
      });
  if (!wanted || !onFloor || picture.instant.imu.hasNaN()) {
    return std::nullopt;
  }
  const bool right = picture.instant.supportFoot == SupportFoot::right;
  return ObservationChain::betweenLinks(measurements.robot, measurements.quantities, 0,
                                        measurements.robot.findSole(right ? "right" : "left")->link);
}

} // namespace

Residuals::Residuals(const Measurements& measurements, const Model& model, const Noise& noise, const Loss& loss)
    : measurements_{measurements}, model_{model}, noise_{noise}, loss_{loss}, sigmas_{model.sigmas()},
      free_(model.unknownCount(), true), prepared_(measurements.pictures.size()), columns_(measurements.poses.size()),
      roots_(measurements.poses.size()) {
  parallelFor(prepared_.size(), [&](std::size_t i) {
    prepared_[i].slopes = EffectJacobian{measurements, model, measurements.pictures[i]};
    prepared_[i].torso = torsoOverFloor(measurements, model, measurements.pictures[i]);
  });
  parallelFor(columns_.size(), [&](std::size_t pose) {
    columns_[pose] = listColumns(measurements.poses[pose]);
    roots_[pose] = jointErrorRoot(columns_[pose], noise_);
    for (const EncoderSample& reading : measurements.poses[pose].readings) {
      for (std::size_t index : reading.pictures) {
        prepareImage(measurements, measurements.pictures[index], columns_[pose].unknowns, prepared_[index]);
      }
    }
  });
}

/// Unknowns that a pose depends on, and one deflection per joint on its paths and encoder error.
PosePart Residuals::listColumns(const PoseGroup& pose) {
  PosePart part;
  std::vector<bool> moves(model_.unknownCount(), false);
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> deflections; // keyed by (motor, encoder error)
  const bool latent = noise_.encoder > 0 || noise_.pose > 0 || noise_.stance > 0 || noise_.reapproach > 0;
  for (const EncoderSample& reading : pose.readings) {
    for (std::size_t index : reading.pictures) {
      PreparedImage& picture = prepared_[index];
      for (const StateDerivative& slope : picture.slopes.entries()) {
        moves[slope.unknown] = true;
      }
      if (latent) {
        picture.joints = observedJoints(measurements_.robot, measurements_.pictures[index]);
      }
      for (std::size_t joint : picture.joints) {
        deflections[{measurements_.robot.joints[joint].motor, reading.encoderError[joint]}];
      }
    }
  }
  for (auto& [joint, number] : deflections) {
    number = part.joints.size();
    part.joints.push_back(joint.first);
    part.errors.push_back(joint.second);
    part.errorScales.push_back(pose.encoderErrors[joint.second].scale);
    part.stances.push_back(pose.encoderErrors[joint.second].stance);
  }
  for (const EncoderSample& reading : pose.readings) {
    for (std::size_t index : reading.pictures) {
      for (std::size_t joint : prepared_[index].joints) {
        prepared_[index].deflections.push_back(
            deflections.at({measurements_.robot.joints[joint].motor, reading.encoderError[joint]}));
      }
    }
  }
  for (std::size_t unknown = 0; unknown < moves.size(); ++unknown) {
    if (moves[unknown]) {
      part.unknowns.push_back(unknown);
    }
  }
  return part;
}

namespace {

/// Splits a pose's normal equations into blocks, re-expressed at zero deflection.
void splitNormalEquations(const NormalEquations& sums, const Eigen::VectorXd& deflections, PoseSystem& system) {
  const Eigen::Index unknowns = eigenIndex(system.unknowns.size()), joints = deflections.size();
  const Eigen::MatrixXd& gram = sums.gram();
  system.unknownGram = gram.topLeftCorner(unknowns, unknowns);
  system.unknownGradient = sums.gradient().head(unknowns);
  system.jointErrorCross = gram.topRightCorner(unknowns, joints);
  system.jointErrorGram = gram.bottomRightCorner(joints, joints);
  system.jointErrorGradient = sums.gradient().tail(joints);
  if (joints == 0) {
    return;
  }
  const Eigen::VectorXd drop = system.jointErrorGram * deflections;
  system.squares += deflections.dot(drop - 2 * system.jointErrorGradient);
  system.jointErrorGradient -= drop;
  system.unknownGradient -= system.jointErrorCross * deflections;
}

/// Minimising deflections of a pose in the linearised problem, with its unknowns moved by `along`.
Eigen::VectorXd minimizingDeflections(const MarginalSystem& part, const Eigen::VectorXd& along = {}) {
  Eigen::VectorXd result = -part.half.rightCols<1>();
  result.noalias() -= part.half.leftCols(along.size()) * along;
  part.inner.matrixU().solveInPlace(result);
  return result;
}

} // namespace

/// Predicts the state at the picture's instant and evaluates its slopes.
void Residuals::predictImageState(const ImageObservation& picture, const PreparedImage& prepared,
                                  const Eigen::VectorXd& unknowns, const Eigen::VectorXd& deflections,
                                  Workspace& work) const {
  work.modelState = picture.nominal;
  prepared.slopes.applyFixed(unknowns, work.modelState);
  work.slopes = prepared.slopeValues.data();
  if (prepared.slopes.hasVarying()) {
    work.varyingSlopes = prepared.slopeValues;
    work.slopes = work.varyingSlopes.data();
    work.drive(measurements_, model_, picture, unknowns);
    prepared.slopes.applyVarying(model_, picture, unknowns, work.scratch, work.modelState,
                                 work.varyingSlopes.data() + prepared.slopes.fixedCount());
  }
  for (std::size_t i = 0; i < prepared.joints.size(); ++i) {
    const std::size_t joint = prepared.joints[i];
    work.modelState.angle(joint) +=
        measurements_.robot.joints[joint].ratio * deflections[eigenIndex(prepared.deflections[i])];
  }
}

/// Adds the sums over a picture's corners to those of its pose. False if a corner has no projection.
bool Residuals::addPicture(const ImageObservation& picture, const PreparedImage& prepared, Workspace& work,
                           PosePart& part) const {
  forwardKinematics(measurements_.robot, work.modelState, prepared.links, work.torsoFromLink);
  for (std::size_t i = 0; i < picture.otherSoles.size(); ++i) {
    addFloorContact(picture.otherSoles[i], prepared.floors[i], work, part);
  }
  if (prepared.torso) {
    addImuReading(picture, prepared, work, part);
  }
  for (std::size_t i = 0; i < picture.witnesses.size(); ++i) {
    addWitness(picture.witnesses[i], prepared.witnesses[i], work, part);
  }
  return std::all_of(prepared.groups.begin(), prepared.groups.end(),
                     [&](const PreparedImage::Group& group) { return addGroup(picture, group, work, part); });
}

/// Adds the corners of an observation to the workspace's sums over corners. False if one has no projection.
bool Residuals::addCorners(const BoardObservation& observation, const std::vector<std::size_t>& extras,
                           CameraFrames& attitude, Workspace& work) const {
  observation.view.placeBoard(work.linkFromBoard(observation.view.board()), attitude);
  if (!observation.view.project(attitude, work.modelState, observation.corners, work.projected)) {
    return false;
  }
  work.extraShifts.clear();
  for (std::size_t extra : extras) {
    for (std::size_t block = 0; block < observation.corners.size(); ++block) {
      work.extraShifts.push_back(ObservationChain::shiftByExtra(extra, attitude, work.modelState,
                                                                observation.corners[block], work.projected[block]));
    }
  }
  work.corners.add(observation.corners, work.projected, work.extraShifts, noise_.pixel,
                   {cornerShare(noise_, observation.repeats), observation.repeats}, loss_);
  return true;
}

/// Adds the corners of all boards of a group, which share one kinematic path. False if a corner has no projection.
bool Residuals::addGroup(const ImageObservation& picture, const PreparedImage::Group& group, Workspace& work,
                         PosePart& part) const {
  const ObservationChain& path = picture.observations[group.observations.front()].view;
  CameraFrames attitude = path.pathFrames({measurements_.robot, work.modelState, work.torsoFromLink});
  if (std::find(group.extras.begin(), group.extras.end(), rowTimeExtra) != group.extras.end()) {
    path.setDrift({measurements_.robot, work.modelState, work.torsoFromLink}, picture.instant.velocity, attitude);
  }
  work.corners.clear(group.extras.size());
  for (std::size_t index : group.observations) {
    if (!addCorners(picture.observations[index], group.extras, attitude, work)) {
      return false;
    }
  }
  work.motion.resize(eigenIndex(6 + group.extras.size()), eigenIndex(group.quantities.size()));
  path.fillMotionColumns({measurements_.robot, work.modelState, work.torsoFromLink}, attitude, group.quantities,
                         group.extras, work.motion);
  work.add(work.corners.gram(), work.corners.gradient(), work.motion, group);
  work.cost += work.corners.cost();
  part.squares += work.corners.squares();
  part.numbers += 2 * work.corners.corners();
  part.freedom += 2 * work.corners.freedom();
  return true;
}

Residuals::State Residuals::startState(const Eigen::VectorXd& unknowns) const {
  State state{unknowns, {}};
  for (const PosePart& pose : columns_) {
    state.deflections.push_back(Eigen::VectorXd::Zero(eigenIndex(pose.joints.size())));
  }
  return state;
}

/// Adds all pictures of a pose to the workspace's sums. False if a corner has no projection.
bool Residuals::addPose(std::size_t pose, const State& state, const Eigen::VectorXd& deflections, Workspace& work,
                        PosePart& part) const {
  part.squares = part.numbers = part.freedom = 0;
  for (const EncoderSample& reading : measurements_.poses[pose].readings) {
    for (std::size_t index : reading.pictures) {
      const ImageObservation& picture = measurements_.pictures[index];
      const PreparedImage& ready = prepared_[index];
      predictImageState(picture, ready, state.unknowns, deflections, work);
      if (!addPicture(picture, ready, work, part)) {
        return false;
      }
    }
  }
  part.loss = work.cost;
  return true;
}

/// Sums a pose at these deflections and marginalises them. False if a corner has no projection.
bool Residuals::linearizeAt(std::size_t pose, const State& state, const Eigen::VectorXd& inSigmas, PoseSystem& system,
                            MarginalSystem& part) const {
  Workspace& work = Workspace::threadWorkspace(measurements_);
  const Eigen::VectorXd deflections = roots_[pose] * inSigmas;
  work.sums.clear(eigenIndex(system.unknowns.size() + system.joints.size()));
  work.wantsRows = false;
  if (!addPose(pose, state, deflections, work, system)) {
    return false;
  }
  splitNormalEquations(work.sums, deflections, system);
  marginalize(system, noise_, roots_[pose], part);
  return true;
}

/// Iterates from a pose's sums until its deflections converge.
void Residuals::settleDeflections(std::size_t pose, State& state, PoseSystem& system, MarginalSystem& part) const {
  constexpr int most = 20;
  constexpr double little = 1e-4; // cost decrease per step
  Eigen::VectorXd& here = state.deflections[pose];
  for (int step = 0; step < most; ++step) {
    Eigen::VectorXd there = minimizingDeflections(part);
    const double gained = 0.5 * (part.inner.matrixU() * (there - here)).squaredNorm();
    if (!(gained > little)) {
      return;
    }
    PoseSystem onward{columns_[pose], {}, {}, {}, {}, {}};
    MarginalSystem onwardPart;
    if (!linearizeAt(pose, state, there, onward, onwardPart) ||
        !(onward.loss + there.squaredNorm() < system.loss + here.squaredNorm())) {
      return;
    }
    here.swap(there);
    system = std::move(onward);
    part = std::move(onwardPart);
  }
}

std::optional<std::vector<PoseRows>> Residuals::rows(const State& state) const {
  std::vector<PoseRows> result(columns_.size());
  std::atomic<bool> possible = true;
  parallelFor(columns_.size(), [&](std::size_t pose) {
    Workspace& work = Workspace::threadWorkspace(measurements_);
    PoseRows& rows = result[pose];
    static_cast<PosePart&>(rows) = columns_[pose];
    const Eigen::VectorXd deflections = roots_[pose] * state.deflections[pose];
    work.rows.clear(eigenIndex(rows.unknowns.size() + rows.joints.size()));
    work.wantsRows = true;
    if (!possible || !addPose(pose, state, deflections, work, rows)) {
      possible = false;
      return;
    }
    work.rows.takeRows(deflections, rows);
  });
  return possible ? std::optional{std::move(result)} : std::nullopt;
}

/// Linearises poses in parallel. False if one is infeasible.
template <class AtPose> bool Residuals::linearisePoses(Linear& result, const AtPose& atPose) const {
  if (result.poses.empty()) {
    for (const PosePart& columns : columns_) {
      result.poses.push_back({columns, {}, {}, {}, {}, {}});
    }
    result.eliminated.resize(columns_.size());
  }
  std::atomic<bool> possible = true;
  parallelFor(columns_.size(), [&](std::size_t pose) {
    if (possible && !atPose(pose, result.poses[pose], result.eliminated[pose])) {
      possible = false;
    }
  });
  return possible;
}

/// Sums the poses in order, and adds the priors.
void Residuals::sumPoses(const State& state, Linear& result) const {
  const Eigen::VectorXd inPrior = state.unknowns.cwiseQuotient(sigmas_);
  result.cost = 0.5 * inPrior.squaredNorm();
  result.gradient = inPrior.cwiseQuotient(sigmas_);
  result.hessian = sigmas_.cwiseAbs2().cwiseInverse().asDiagonal();
  for (std::size_t pose = 0; pose < columns_.size(); ++pose) {
    const PoseSystem& system = result.poses[pose];
    const MarginalSystem& part = result.eliminated[pose];
    result.cost += 0.5 * (system.loss + state.deflections[pose].squaredNorm());
    result.gradient(system.unknowns) += part.unknownGradient;
    result.hessian(system.unknowns, system.unknowns) += part.hessian;
  }
  for (std::size_t i = 0; i < free_.size(); ++i) {
    if (!free_[i]) {
      result.gradient[eigenIndex(i)] = 0;
      result.hessian.row(eigenIndex(i)).setZero();
      result.hessian.col(eigenIndex(i)).setZero();
      result.hessian(eigenIndex(i), eigenIndex(i)) = 1;
    }
  }
}

std::optional<Residuals::Linear> Residuals::linearize(const State& state) const {
  std::optional<Linear> result{std::in_place};
  const bool possible = linearisePoses(*result, [&](std::size_t pose, PoseSystem& system, MarginalSystem& part) {
    return linearizeAt(pose, state, state.deflections[pose], system, part);
  });
  if (!possible) {
    return std::nullopt;
  }
  sumPoses(state, *result);
  return result;
}

bool Residuals::linearize(State& state, Linear& result) const {
  const bool possible = linearisePoses(result, [&](std::size_t pose, PoseSystem& system, MarginalSystem& part) {
    if (!linearizeAt(pose, state, state.deflections[pose], system, part)) {
      return false;
    }
    if (!columns_[pose].joints.empty()) {
      settleDeflections(pose, state, system, part);
    }
    return true;
  });
  if (possible) {
    sumPoses(state, result);
  }
  return possible;
}

Residuals::State Residuals::applyStep(const State& state, const Linear& linear, const Eigen::VectorXd& step) const {
  State result{state.unknowns + step, {}};
  for (std::size_t pose = 0; pose < columns_.size(); ++pose) {
    if (columns_[pose].joints.empty()) {
      result.deflections.emplace_back();
      continue;
    }
    const MarginalSystem& part = linear.eliminated[pose];
    Eigen::VectorXd along = Eigen::VectorXd::Zero(part.half.cols() - 1);
    for (std::size_t i = 0; i < columns_[pose].unknowns.size(); ++i) {
      along[eigenIndex(i)] = step[eigenIndex(columns_[pose].unknowns[i])];
    }
    result.deflections.push_back(minimizingDeflections(part, along));
  }
  return result;
}

/// Calls visit(pose, picture, work) for every picture in pose order, with the workspace at the picture's state. Ends
/// early, and returns false, where a visit does.
template <class Visit> bool Residuals::visitPictures(const State& state, const Visit& visit) const {
  Workspace& work = Workspace::threadWorkspace(measurements_);
  for (std::size_t pose = 0; pose < columns_.size(); ++pose) {
    const Eigen::VectorXd deflections = roots_[pose] * state.deflections[pose];
    for (const EncoderSample& reading : measurements_.poses[pose].readings) {
      for (std::size_t index : reading.pictures) {
        predictImageState(measurements_.pictures[index], prepared_[index], state.unknowns, deflections, work);
        forwardKinematics(measurements_.robot, work.modelState, prepared_[index].links, work.torsoFromLink);
        if (!visit(pose, index, work)) {
          return false;
        }
      }
    }
  }
  return true;
}

std::optional<std::vector<BoardMotionSums>> Residuals::boardMotions(const State& state) const {
  std::vector<BoardMotionSums> result;
  const bool possible = visitPictures(state, [&](std::size_t pose, std::size_t index, Workspace& work) {
    const Eigen::Index columns = eigenIndex(columns_[pose].unknowns.size() + columns_[pose].joints.size());
    for (const PreparedImage::Group& group : prepared_[index].groups) {
      for (std::size_t observation : group.observations) {
        BoardMotionSums motion{.picture = index, .observation = observation, .pose = pose};
        motion.cross.setZero(6, columns);
        if (!addMotion(measurements_.pictures[index].observations[observation], group, work, motion)) {
          return false;
        }
        result.push_back(std::move(motion));
      }
    }
    return true;
  });
  return possible ? std::optional{std::move(result)} : std::nullopt;
}

/// Computes an observation's motion sums. False if a corner has no projection.
bool Residuals::addMotion(const BoardObservation& observation, const PreparedImage::Group& group, Workspace& work,
                          BoardMotionSums& motion) const {
  CameraFrames attitude = observation.view.pathFrames({measurements_.robot, work.modelState, work.torsoFromLink});
  if (std::find(group.extras.begin(), group.extras.end(), rowTimeExtra) != group.extras.end()) {
    observation.view.setDrift({measurements_.robot, work.modelState, work.torsoFromLink},
                              measurements_.pictures[motion.picture].instant.velocity, attitude);
  }
  work.corners.clear(group.extras.size());
  if (!addCorners(observation, group.extras, attitude, work)) {
    return false;
  }
  work.motion.resize(eigenIndex(6 + group.extras.size()), eigenIndex(group.quantities.size()));
  observation.view.fillMotionColumns({measurements_.robot, work.modelState, work.torsoFromLink}, attitude,
                                     group.quantities, group.extras, work.motion);
  const ImageNormalEquations::Square gram = work.corners.gram();
  motion.gram = gram.topLeftCorner<6, 6>();
  motion.gradient = work.corners.gradient().head<6>();
  const Eigen::MatrixXd byQuantities = gram.topRows<6>() * work.motion;
  for (const PreparedImage::Group::Share& share : group.shares) {
    motion.cross.col(group.columns[share.column]) += work.slopes[share.slope] * byQuantities.col(share.quantity);
  }
  return true;
}

std::vector<BoardResidual> Residuals::boardResiduals(const State& state) const {
  std::vector<BoardResidual> result;
  visitPictures(state, [&](std::size_t, std::size_t index, Workspace& work) {
    for (std::size_t i = 0; i < measurements_.pictures[index].observations.size(); ++i) {
      result.push_back(boardResidual(index, i, work));
    }
    return true;
  });
  return result;
}

std::vector<WitnessResidual> Residuals::witnessResiduals(const State& state) const {
  std::vector<WitnessResidual> result;
  if (measurements_.witnessCount == 0) {
    return result;
  }
  visitPictures(state, [&](std::size_t, std::size_t index, Workspace& work) {
    const std::vector<WitnessObservation>& witnesses = measurements_.pictures[index].witnesses;
    for (std::size_t i = 0; i < witnesses.size(); ++i) {
      std::optional<CameraFrames> frames;
      WitnessResidual& one =
          result.emplace_back(WitnessResidual{index, i, compareWitness(witnesses[i], work, frames).residual});
      for (const Witness::Part& part : witnesses[i].witness->parts()) {
        one.weight = std::min(one.weight, lossOf(witnesses[i], one.residual, part).weight);
      }
    }
    return true;
  });
  return result;
}

/// Residuals of one board in one picture, at the workspace's state; not finite if a corner has no projection.
BoardResidual Residuals::boardResidual(std::size_t picture, std::size_t index, Workspace& work) const {
  const BoardObservation& observation = measurements_.pictures[picture].observations[index];
  CameraFrames attitude = observation.view.cameraFrames({measurements_.robot, work.modelState, work.torsoFromLink});
  if (work.modelState.rowTime() != 0) {
    observation.view.setDrift({measurements_.robot, work.modelState, work.torsoFromLink},
                              measurements_.pictures[picture].instant.velocity, attitude);
  }
  const Eigen::Index count = eigenIndex(observation.ids.size());
  BoardResidual result{picture,
                       index,
                       Eigen::Matrix2Xd(2, count),
                       Eigen::Matrix2Xd(2, count),
                       Eigen::VectorXd::Zero(count),
                       Eigen::MatrixXd::Zero(2 * count, 6)};
  if (!observation.view.project(attitude, work.modelState, observation.corners, work.projected)) {
    result.predicted.setConstant(std::numeric_limits<double>::quiet_NaN());
    result.residual = result.predicted;
    return result;
  }
  const double information = cornerShare(noise_, observation.repeats) / (noise_.pixel * noise_.pixel);
  for (Eigen::Index i = 0; i < count; ++i) {
    const CornerBlock& corner = observation.corners[static_cast<std::size_t>(i / 4)];
    const ProjectedBlock& seen = work.projected[static_cast<std::size_t>(i / 4)];
    result.predicted.col(i) << seen.u[i % 4], seen.v[i % 4];
    result.residual.col(i) << corner.u[i % 4] - seen.u[i % 4], corner.v[i % 4] - seen.v[i % 4];
    for (Eigen::Index k = 0; k < 6; ++k) {
      result.motionRows(2 * i, k) = seen.rowsU[k][i % 4];
      result.motionRows(2 * i + 1, k) = seen.rowsV[k][i % 4];
    }
    result.weight[i] = corner.present[i % 4] * loss_(information * result.residual.col(i).squaredNorm()).weight;
  }
  return result;
}

std::vector<double> collectDistances(const std::vector<BoardResidual>& residuals) {
  std::vector<double> distances;
  for (const BoardResidual& board : residuals) {
    for (Eigen::Index i = 0; i < board.residual.cols(); ++i) {
      distances.push_back(board.residual.col(i).norm());
    }
  }
  return distances;
}

ResidualSummary summarizeDistances(std::vector<double> distances) {
  ResidualSummary result{0, 0, distances.size()};
  if (distances.empty()) {
    return result;
  }
  double squares = 0;
  for (const double distance : distances) {
    squares += distance * distance;
  }
  result.rmsPx = result.medianPx = std::sqrt(squares / static_cast<double>(distances.size()));
  if (!std::isfinite(result.rmsPx)) { // NaN has no order
    return result;
  }
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  result.medianPx = *middle;
  return result;
}

} // namespace naocal
