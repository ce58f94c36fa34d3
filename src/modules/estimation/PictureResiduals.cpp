#include "estimation/PictureResiduals.hpp"

#include "math/LinearAlgebra.hpp"
#include "measurements/FloorContact.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace naocal {

PictureResiduals::PictureResiduals(const Measurements& measurements, const Model& model, const Noise& noise,
                                   const Loss& loss)
    : measurements_{measurements}, model_{model}, noise_{noise}, loss_{loss} {}

void PictureResiduals::predictState(const ImageObservation& picture, const PreparedImage& prepared,
                                    const Eigen::VectorXd& unknowns, const Eigen::VectorXd& deflections,
                                    PictureWorkspace& work) const {
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
  forwardKinematics(measurements_.robot, work.modelState, prepared.links, work.torsoFromLink);
}

bool PictureResiduals::add(const ImageObservation& picture, const PreparedImage& prepared, PictureWorkspace& work,
                           PosePart& part) const {
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

/// Floor contact: height and tilt of another sole over the floor are zero with sigmas `FloorContact`. In units of
/// pixels, like all sums.
void PictureResiduals::addFloorContact(const ObservationChain& sole, const PreparedImage::Group& group,
                                       PictureWorkspace& work, PosePart& part) const {
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
WitnessRows PictureResiduals::compareWitness(const WitnessObservation& observation, const PictureWorkspace& work,
                                             std::optional<CameraFrames>& frames) const {
  if (observation.view) {
    frames = observation.view->pathFrames({measurements_.robot, work.modelState, work.torsoFromLink});
  }
  return observation.witness->compare(frames ? frames->opticalFromWorld : RigidTransform{}, work.modelState);
}

/// Loss of one part of a reading, by the length of its error over sigma. What the robot takes no part in, a known
/// distance, is never doubted: it tells the scale.
Loss::Value PictureResiduals::lossOf(const WitnessObservation& observation,
                                     const Eigen::Ref<const Eigen::VectorXd>& residual,
                                     const Witness::Part& part) const {
  const double sigma = sigmaOf(measurements_, noise_, part.level);
  const double squares = residual.segment(part.first, part.count).squaredNorm() / (sigma * sigma);
  const auto [rho, weight] = observation.view ? loss_(squares) : Loss::Value{squares, 1};
  return {observation.weight * rho, observation.weight * weight};
}

/// A witness: its rows over the sigma of their level, in units of pixels, like all sums. Each part has the loss of its
/// own distance.
void PictureResiduals::addWitness(const WitnessObservation& observation, const PreparedImage::Group& group,
                                  PictureWorkspace& work, PosePart& part) const {
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
void PictureResiduals::addImuReading(const ImageObservation& picture, const PreparedImage& prepared,
                                     PictureWorkspace& work, PosePart& part) const {
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

/// Adds the corners of an observation to the workspace's sums over corners. False if one has no projection.
bool PictureResiduals::addCorners(const BoardObservation& observation, const std::vector<std::size_t>& extras,
                                  CameraFrames& attitude, PictureWorkspace& work) const {
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
bool PictureResiduals::addGroup(const ImageObservation& picture, const PreparedImage::Group& group,
                                PictureWorkspace& work, PosePart& part) const {
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

BoardResidual PictureResiduals::boardResidual(std::size_t picture, std::size_t index, PictureWorkspace& work) const {
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

WitnessResidual PictureResiduals::witnessResidual(std::size_t picture, std::size_t index,
                                                  const PictureWorkspace& work) const {
  const WitnessObservation& observation = measurements_.pictures[picture].witnesses[index];
  std::optional<CameraFrames> frames;
  WitnessResidual result{picture, index, compareWitness(observation, work, frames).residual};
  for (const Witness::Part& part : observation.witness->parts()) {
    result.weight = std::min(result.weight, lossOf(observation, result.residual, part).weight);
  }
  return result;
}

bool PictureResiduals::addMotion(const BoardObservation& observation, const PreparedImage::Group& group,
                                 PictureWorkspace& work, BoardMotionSums& motion) const {
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

} // namespace naocal
