#include "residuals/RecordedPicture.hpp"

#include "io/InputError.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace naocal {

namespace {

/// Per joint of the robot, what `list` holds for it, or NaN. Joints of one motor have one reading.
Eigen::VectorXd perJoint(const Robot& robot, const CaptureSet& set, const std::vector<double>& list) {
  Eigen::VectorXd values = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(robot.joints.size()), Instant::nothing);
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (const auto joint = robot.jointIndex(set.jointNames[i])) {
      values[static_cast<Eigen::Index>(*joint)] = list[i];
    }
  }
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const auto own = static_cast<Eigen::Index>(joint);
    const auto motor = static_cast<Eigen::Index>(robot.joints[joint].motor);
    if (own != motor) {
      if (std::isnan(values[motor])) {
        values[motor] = values[own];
      }
      values[own] = values[motor];
    }
  }
  return values;
}

/// The left foot's share of the weight, as the force sensors tell.
double leftLoad(const Capture& capture) {
  if (!capture.fsr) {
    return Instant::nothing;
  }
  const auto middle = capture.fsr->begin() + 4;
  const double left = std::accumulate(capture.fsr->begin(), middle, 0.0);
  const double right = std::accumulate(middle, capture.fsr->end(), 0.0);
  return left + right > 0 ? left / (left + right) : Instant::nothing;
}

std::size_t targetLink(const Robot& robot, const Target& target, SupportFoot foot) {
  return target.onFloor ? robot.sole(foot == SupportFoot::right ? "right" : "left")->link
                        : *robot.linkIndex(target.board.link);
}

void addSighting(const CaptureSet& set, const Capture& capture, const BoardCorners& corners, std::size_t targetIndex,
                 const Measurements& measurements, Picture& result) {
  const Robot& robot = measurements.robot;
  const Target& target = measurements.targets[targetIndex];
  if (corners.ids.empty() || (target.onFloor && capture.supportFoot == SupportFoot::none)) {
    return; // a hanging robot learns nothing from the floor
  }
  View view{robot,          measurements.quantities,
            result.camera,  targetLink(robot, target, capture.supportFoot),
            target.onFloor, targetIndex};
  for (std::size_t joint : view.joints()) {
    if (std::isnan(result.instant.q[static_cast<Eigen::Index>(joint)])) {
      throw InputError{fmt::format("{}: capture {}: joints.measured: {} was not recorded but board {} is seen along it",
                                   set.name, capture.id, robot.joints[joint].name, corners.board)};
    }
  }
  result.sightings.push_back({std::move(view), cornerBlocks(target.board, corners), corners.ids});
}

/// The readings, or resting angles where there are none.
void drawAngles(const Robot& robot, Picture& result) {
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    double& angle = result.instant.q[static_cast<Eigen::Index>(joint)];
    if (std::isnan(angle)) {
      angle = robot.joints[joint].resting;
    }
    result.drawn.angle(joint) = angle;
  }
}

/// The file's lens, and placements known or guessed.
void drawScene(const CameraIntrinsics& camera, const Measurements& measurements, Picture& result) {
  result.drawn.lens().head<4>() << camera.fx, camera.fy, camera.cx, camera.cy;
  for (std::size_t i = 0; i < camera.distortion.size(); ++i) {
    result.drawn.lens()[static_cast<Eigen::Index>(4 + i)] = camera.distortion[i];
  }
  const auto numbers = [](const Placement& p) {
    return (Eigen::Matrix<double, 6, 1>{} << p.x, p.y, p.z, p.roll, p.pitch, p.yaw).finished();
  };
  result.drawn.ground() = numbers(measurements.standings[result.stance].placement);
  for (std::size_t target = 0; target < measurements.targets.size(); ++target) {
    const Board& board = measurements.targets[target].board;
    result.drawn.boardPlacement(target) = numbers(board.placement.value_or(board.placementGuess));
  }
}

} // namespace

Picture recordedPicture(const std::vector<CaptureSet>& sets, std::size_t setIndex, std::size_t index,
                        const Measurements& measurements, const Places& places) {
  const Robot& robot = measurements.robot;
  const CaptureSet& set = sets[setIndex];
  const Capture& capture = set.captures[index];
  if (!capture.corners) {
    throw InputError{fmt::format("{}: captures[{}] (id {}): no corners yet; run 'naocal detect {}' first", set.name,
                                 index, capture.id, set.name)};
  }
  const auto camera = robot.cameraIndex(capture.camera);
  if (!camera) {
    throw InputError{fmt::format("{}: captures[{}].camera: the {} has no camera '{}'", set.name, index, robot.model,
                                 capture.camera)};
  }
  Picture result{.set = setIndex,
                 .capture = index,
                 .camera = *camera,
                 .stance = places.standingIndex(set, capture.stance),
                 .instant = {.time = capture.time,
                             .supportFoot = capture.supportFoot,
                             .q = perJoint(robot, set, capture.joints.measured),
                             .velocity = perJoint(robot, set, capture.joints.velocity),
                             .approach = perJoint(robot, set, capture.joints.approach),
                             .temperature = perJoint(robot, set, capture.joints.temperature),
                             .current = perJoint(robot, set, capture.joints.current),
                             .imu = capture.imu.value_or(Eigen::Vector2d::Constant(Instant::nothing)),
                             .leftLoad = leftLoad(capture)},
                 .drawn = drawnBelief(robot, measurements.quantities),
                 .sightings = {}};
  for (const BoardCorners& corners : *capture.corners) {
    addSighting(set, capture, corners, places.targetIndex(set, corners.board), measurements, result);
  }
  drawAngles(robot, result);
  drawScene(set.cameras.at(capture.camera), measurements, result);
  return result;
}

} // namespace naocal
