#include "measurements/CaptureReading.hpp"

#include "io/InputError.hpp"

#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numeric>
#include <set>

namespace naocal {

namespace {

/// How a joint that mimics follows its motor's joint: as its angle, as its speed, or with the same value.
enum class Follows { angle, speed, value };

double followed(const Joint& joint, double ofMotor, Follows how) {
  return how == Follows::angle   ? joint.ratio * ofMotor + joint.shift
         : how == Follows::speed ? joint.ratio * ofMotor
                                 : ofMotor;
}

/// Values of `list` per joint of the robot, or NaN. Joints of one motor follow it; where only another of its joints was
/// recorded, that joint's ratio tells the motor's.
Eigen::VectorXd perJoint(const Robot& robot, const CaptureSet& set, const std::vector<double>& list, Follows how) {
  Eigen::VectorXd values =
      Eigen::VectorXd::Constant(static_cast<Eigen::Index>(robot.joints.size()), RobotSample::nothing);
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (const auto joint = robot.jointIndex(set.jointNames[i])) {
      values[static_cast<Eigen::Index>(*joint)] = list[i];
    }
  }
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const auto own = static_cast<Eigen::Index>(joint);
    const auto motor = static_cast<Eigen::Index>(robot.joints[joint].motor);
    if (own != motor) {
      const Joint& follower = robot.joints[joint];
      if (std::isnan(values[motor]) && (how == Follows::value || follower.ratio != 0)) {
        values[motor] =
            how == Follows::value ? values[own] : (values[own] - followed(follower, 0, how)) / follower.ratio;
      }
      values[own] = followed(follower, values[motor], how);
    }
  }
  return values;
}

/// The left foot's share of the weight according to the force sensors; NaN if unknown.
double leftLoad(const Capture& capture) {
  if (!capture.fsr) {
    return RobotSample::nothing;
  }
  const auto middle = capture.fsr->begin() + 4;
  const double left = std::accumulate(capture.fsr->begin(), middle, 0.0);
  const double right = std::accumulate(middle, capture.fsr->end(), 0.0);
  return left + right > 0 ? left / (left + right) : RobotSample::nothing;
}

void addObservation(const CaptureSet& set, const Capture& capture, const BoardCorners& corners, std::size_t targetIndex,
                    const Measurements& measurements, ImageObservation& result) {
  const Robot& robot = measurements.robot;
  const Target& target = measurements.targets[targetIndex];
  const std::optional<std::size_t> support = measurements.stances[result.stance].supportLink;
  if (corners.ids.empty() || (target.inWorld && !support)) {
    return;
  }
  const std::size_t link = target.inWorld ? *support : *robot.linkIndex(target.board.link);
  const bool standsBeside = robot.cameras[result.camera].inWorld;
  if (standsBeside && (!support || target.inWorld)) {
    return; // tells nothing about the robot
  }
  ObservationChain view{robot,
                        measurements.quantities,
                        result.camera,
                        {link, target.inWorld, targetIndex},
                        standsBeside ? support : std::nullopt};
  for (std::size_t joint : view.joints()) {
    if (std::isnan(result.instant.q[static_cast<Eigen::Index>(joint)])) {
      throw InputError{fmt::format("{}: capture {}: joints.measured: {} was not recorded but board {} is seen along it",
                                   set.name, capture.id, robot.joints[joint].name, corners.board)};
    }
  }
  result.observations.push_back({std::move(view), packCorners(target.board, corners), corners.ids});
}

/// Measured angles, or rest angles where not recorded.
void drawAngles(const Robot& robot, ImageObservation& result) {
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    double& angle = result.instant.q[static_cast<Eigen::Index>(joint)];
    if (std::isnan(angle)) {
      angle = robot.joints[joint].restAngle;
    }
    result.nominal.angle(joint) = angle;
  }
}

void drawLens(const CameraIntrinsics& camera, ImageObservation& result) {
  result.nominal.lens().head<4>() << camera.fx, camera.fy, camera.cx, camera.cy;
  for (std::size_t i = 0; i < camera.distortion.size(); ++i) {
    result.nominal.lens()[static_cast<Eigen::Index>(4 + i)] = camera.distortion[i];
  }
}

/// Sets known or guessed placements.
void drawScene(const Measurements& measurements, ImageObservation& result) {
  result.nominal.worldFromSupport() = measurements.stances[result.stance].placement.numbers();
  for (std::size_t target = 0; target < measurements.targets.size(); ++target) {
    const Board& board = measurements.targets[target].board;
    result.nominal.boardPlacement(target) = board.placement.value_or(board.placementGuess).numbers();
  }
}

/// Against gravity, in the support's frame.
Eigen::Vector3d upInSupport(const CaptureSet& set, const StanceInstance& stance) {
  return transformFromPlacement(stance.placement.numbers()).rotation.transpose() * -set.gravity.normalized();
}

} // namespace

std::vector<std::size_t> recordedMotors(const std::vector<CaptureSet>& sets, const Robot& robot) {
  std::map<std::size_t, std::size_t> captures; // motor -> number of captures
  std::size_t all = 0;
  for (const CaptureSet& set : sets) {
    for (const Capture& capture : set.captures) {
      ++all;
      std::set<std::size_t> motors;
      for (std::size_t i = 0; i < set.jointNames.size(); ++i) {
        const auto joint = robot.jointIndex(set.jointNames[i]);
        if (joint && !std::isnan(capture.joints.measured[i])) {
          motors.insert(robot.joints[*joint].motor);
        }
      }
      for (const std::size_t motor : motors) {
        ++captures[motor];
      }
    }
  }
  std::vector<std::size_t> result;
  for (const auto& [motor, count] : captures) {
    if (count == all) {
      result.push_back(motor);
    }
  }
  return result;
}

Eigen::VectorXd measuredAngles(const Robot& robot, const CaptureSet& set, const Capture& capture) {
  return perJoint(robot, set, capture.joints.measured, Follows::angle);
}

ImageObservation makeImageObservation(std::size_t setIndex, std::size_t index, const Measurements& measurements,
                                      const FrameRegistry& places) {
  const Robot& robot = measurements.robot;
  const CaptureSet& set = (*measurements.sets)[setIndex];
  const Capture& capture = set.captures[index];
  const bool hasPicture = !capture.camera.empty();
  if (hasPicture && !capture.corners) {
    throw InputError{fmt::format("{}: captures[{}] (id {}): no corners yet; run 'naocal detect {}' first", set.name,
                                 index, capture.id, set.name)};
  }
  const auto camera = robot.cameraIndex(capture.camera);
  if (hasPicture && !camera) {
    throw InputError{fmt::format("{}: captures[{}].camera: the {} has no camera '{}'", set.name, index, robot.model,
                                 capture.camera)};
  }
  ImageObservation result{.set = setIndex,
                          .capture = index,
                          .camera = camera.value_or(ImageObservation::noCamera),
                          .stance = places.stanceIndex(set, capture.stance),
                          .instant = {.time = capture.time,
                                      .supportFoot = capture.supportFoot,
                                      .q = measuredAngles(robot, set, capture),
                                      .velocity = perJoint(robot, set, capture.joints.velocity, Follows::speed),
                                      .approach = perJoint(robot, set, capture.joints.approach, Follows::value),
                                      .temperature = perJoint(robot, set, capture.joints.temperature, Follows::value),
                                      .current = perJoint(robot, set, capture.joints.current, Follows::value),
                                      .imu = capture.imu.value_or(Eigen::Vector2d::Constant(RobotSample::nothing)),
                                      .leftLoad = leftLoad(capture)},
                          .nominal = nominalState(robot, measurements.quantities),
                          .observations = {}};
  if (!set.urdf.empty()) {
    const StanceInstance& stance = measurements.stances[result.stance];
    result.instant.supportLink = stance.supportLink;
    result.instant.upInSupport = upInSupport(set, stance);
  }
  for (const BoardCorners& corners : capture.corners.value_or(std::vector<BoardCorners>{})) {
    addObservation(set, capture, corners, places.targetIndex(set, corners.board), measurements, result);
  }
  drawAngles(robot, result);
  drawScene(measurements, result);
  if (hasPicture) {
    drawLens(set.cameras.at(capture.camera), result);
  }
  return result;
}

} // namespace naocal
