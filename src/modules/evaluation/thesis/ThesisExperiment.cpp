#include "evaluation/thesis/ThesisExperiment.hpp"

#include "estimation/ModelBuilder.hpp"
#include "math/LinearAlgebra.hpp"
#include "poses/candidates/BoardPlacement.hpp"
#include "robot/Balance.hpp"
#include "simulation/SyntheticCamera.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace naocal {

namespace {

/// Finds the visible corners of a target and their positions; none if fewer than the limit are visible.
void findSeen(const Board& target, const CameraFrames& attitude, const ProjectedBlocks& projected,
              const CameraIntrinsics& lens, const VisibilityLimits& limits, BoardCorners& seen) {
  const double height = attitude.opticalFromBoard.inverse().translation.z(); // of the camera above the floor
  seen.ids.clear();
  seen.uv.clear();
  for (std::size_t i = 0; i < target.points.size(); ++i) {
    const double u = projected[i / 4].u[i % 4], v = projected[i / 4].v[i % 4];
    if (u < limits.border || u > lens.width - 1 - limits.border || v < limits.border ||
        v > lens.height - 1 - limits.border) {
      continue;
    }
    const double distance = (attitude.opticalFromBoard * target.points[i]).norm();
    if (distance >= limits.nearest && distance <= limits.farthest && height >= distance * std::sin(limits.grazing)) {
      seen.ids.push_back(static_cast<int>(i));
      seen.uv.emplace_back(u, v);
    }
  }
  if (seen.ids.size() < limits.corners) {
    seen.ids.clear();
  }
}

/// A target's points in the left sole's frame [m].
Eigen::Matrix2Xd pointsOnFloor(const Board& target) {
  Eigen::Matrix2Xd points(2, eigenIndex(target.points.size()));
  for (std::size_t i = 0; i < target.points.size(); ++i) {
    points.col(eigenIndex(i)) = (isometryFromPlacement(target.placement.value()) * target.points[i]).head<2>();
  }
  return points;
}

void addNoise(ImageObservation& picture, double pixel, RandomStream& chance) {
  for (BoardObservation& observation : picture.observations) {
    for (CornerBlock& block : observation.corners) {
      for (int i = 0; i < 4; ++i) {
        block.u[i] += chance.normal(pixel);
        block.v[i] += chance.normal(pixel);
      }
    }
  }
}

/// Measurements of all targets in all poses: one image per camera and sample, containing every corner.
Measurements observeEverything(const Robot& robot, const ThesisScene& scenery, const ThesisSetting& setting,
                               const std::vector<ThesisPose>& poses) {
  CaptureSet set{.name = "thesis", .model = robot.model, .cameras = scenery.cameras, .boards = scenery.targets};
  set.stances = {{0, SupportFoot::left, Placement{}}, {1, SupportFoot::right, Placement{.y = -footDistance}}};
  for (Board& board : set.boards) {
    if (setting.unknownPlaces) {
      board.placementGuess = *board.placement;
      board.hasGuess = true;
      board.placement.reset();
    }
  }
  for (const Joint& joint : robot.joints) {
    set.jointNames.push_back(joint.name);
  }
  std::vector<BoardCorners> all;
  for (const Board& board : scenery.targets) {
    BoardCorners& corners = all.emplace_back(BoardCorners{board.id, std::vector<int>(board.points.size()), {}});
    std::iota(corners.ids.begin(), corners.ids.end(), 0);
    corners.uv.assign(board.points.size(), Eigen::Vector2d::Zero());
  }
  for (std::size_t pose = 0; pose < poses.size(); ++pose) {
    for (std::size_t sample = 0; sample < setting.samples; ++sample) {
      for (const auto& [camera, lens] : scenery.cameras) {
        Capture& capture = set.captures.emplace_back();
        capture.id = static_cast<int>(set.captures.size());
        capture.pose = fmt::format("P{:04}", pose);
        capture.repeat = static_cast<int>(sample);
        capture.repeatKind = RepeatKind::reapproach; // new reading errors for each sample
        capture.camera = camera;
        capture.supportFoot = poses[pose].foot;
        capture.stance = poses[pose].foot == SupportFoot::left ? 0 : 1;
        capture.joints.measured.assign(poses[pose].angles.begin(), poses[pose].angles.end());
        capture.corners = all;
      }
    }
  }
  return buildMeasurements({set}, robot);
}

} // namespace

ThesisExperiment::ThesisExperiment(const Robot& robot, const ThesisSetting& setting,
                                   const std::vector<ThesisPose>& poses, const ThesisInputs& inputs)
    : inputs_{inputs}, scenery_{makeThesisScene(setting.feature, inputs.features)},
      everything_{observeEverything(robot, scenery_, setting, poses)} {
  std::vector<Effect> effects{jointOffset()};
  if (setting.unknownPlaces) {
    effects.push_back(cameraRotation());
  }
  model_ = buildModel(everything_, {}, {}, effects);
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const auto motor = std::find(joints().begin(), joints().end(), robot.joints[joint].motor);
    if (motor != joints().end()) {
      driven_.emplace_back(joint, motor - joints().begin());
    }
  }
  if (scenery_.hasHorizonTest) {
    tested_ = bottomCamera<double>();
    for (const Target& target : everything_.targets) {
      targetPoints_.push_back(pointsOnFloor(target.board));
    }
  }
}

template <typename Scalar> SoleCamera<Scalar> ThesisExperiment::bottomCamera() const {
  const Robot& robot = everything_.robot;
  return {robot, robot.cameraIndex("bottom").value(), robot.findSole("left")->link, joints(),
          scenery_.cameras.at("bottom")};
}

template SoleCamera<float> ThesisExperiment::bottomCamera() const;
template SoleCamera<double> ThesisExperiment::bottomCamera() const;

Eigen::Vector2d ThesisExperiment::floorPoint(const BoardObservation& observation, std::size_t corner) const {
  return targetPoints_[observation.view.board()].col(eigenIndex(corner));
}

Eigen::Matrix2Xd ThesisExperiment::floorPoints() const {
  Eigen::Matrix2Xd all(2, 0);
  for (const Eigen::Matrix2Xd& points : targetPoints_) {
    all.conservativeResize(2, all.cols() + points.cols());
    all.rightCols(points.cols()) = points;
  }
  return all;
}

std::vector<std::array<Eigen::Vector2d, 4>> ThesisExperiment::fieldsOfView() const {
  const SoleCamera<double> camera = bottomCamera<double>();
  std::vector<std::array<Eigen::Vector2d, 4>> result;
  for (const PoseGroup& pose : everything_.poses) {
    const ModelState& nominal = everything_.pictures[pose.readings.front().pictures.front()].nominal;
    Eigen::VectorXd angles(eigenIndex(joints().size()));
    for (std::size_t i = 0; i < joints().size(); ++i) {
      angles[eigenIndex(i)] = nominal.angle(joints()[i]);
    }
    if (const auto view = fieldOfView(camera, camera.cameraFromSole(angles), programReach)) {
      result.push_back(*view);
    }
  }
  return result;
}

std::vector<std::string> ThesisExperiment::jointNames() const {
  std::vector<std::string> names;
  for (const std::size_t joint : joints()) {
    names.push_back(everything_.robot.joints[joint].name);
  }
  return names;
}

/// The same as the thesis's program sees: if the picture passes the horizon test, all points that lie in it.
void ThesisExperiment::lookAsProgram(const ImageObservation& all, const Eigen::VectorXd& angles,
                                     ImageObservation& seen) const {
  thread_local BoardCorners corners;
  thread_local Eigen::Matrix2Xd pixels;
  seen.observations.clear();
  const auto cameraFromSole = tested_->cameraFromSole(angles);
  if (!passesHorizonTest(*tested_, cameraFromSole)) {
    return;
  }
  for (const BoardObservation& observation : all.observations) {
    const Board& target = everything_.targets[observation.view.board()].board;
    tested_->project(cameraFromSole, targetPoints_[observation.view.board()], pixels);
    corners.ids.clear();
    corners.uv.clear();
    for (Eigen::Index i = 0; i < pixels.cols(); ++i) {
      if (isInImage(tested_->lens(), pixels.col(i))) {
        corners.ids.push_back(static_cast<int>(i));
        corners.uv.emplace_back(pixels.col(i));
      }
    }
    if (!corners.ids.empty()) {
      seen.observations.push_back({observation.view, packCorners(target, corners), corners.ids});
    }
  }
}

/// Fills `seen` with the visible corners when the experiment's joints have these true angles.
void ThesisExperiment::look(const ImageObservation& all, const Eigen::VectorXd& angles, const Eigen::VectorXd& truth,
                            ImageObservation& seen) const {
  thread_local LinkPoses torsoFromLink;
  thread_local ProjectedBlocks projected;
  thread_local BoardCorners corners;
  if (tested_) {
    lookAsProgram(all, angles, seen);
    return;
  }
  const Robot& robot = everything_.robot;
  ModelState real = all.nominal;
  for (const auto& [joint, i] : driven_) {
    real.angle(joint) = angles[i];
  }
  for (std::size_t term = joints().size(); term < model_.terms().size(); ++term) { // mounts and places
    const Term& other = model_.terms()[term];
    for (const CorrectedPlace& place : placesOn(other, everything_, all)) {
      place.correct(real, other.effect, all.instant, other.values(truth));
    }
  }
  forwardKinematics(robot, real, all.observations.front().view.links(), torsoFromLink);
  CameraFrames attitude = all.observations.front().view.pathFrames({robot, real, torsoFromLink});
  const CameraIntrinsics& lens = scenery_.cameras.at(robot.cameras[all.camera].name);
  seen.observations.clear();
  for (const BoardObservation& observation : all.observations) {
    observation.view.placeBoard(transformFromPlacement(real.boardPlacement(observation.view.board())), attitude);
    if (!observation.view.project(attitude, real, observation.corners, projected)) {
      continue;
    }
    const Board& target = everything_.targets[observation.view.board()].board;
    findSeen(target, attitude, projected, lens, scenery_.limits, corners);
    if (!corners.ids.empty()) {
      seen.observations.push_back({observation.view, packCorners(target, corners), corners.ids});
    }
  }
}

void ThesisExperiment::simulate(const Eigen::VectorXd& truth, const std::function<AngleReading(double)>& read,
                                double pixel, RandomStream& chance, Measurements& taken) const {
  Eigen::VectorXd angles{eigenIndex(joints().size())}, reported = angles;
  for (const PoseGroup& pose : everything_.poses) {
    for (const EncoderSample& each : pose.readings) {
      const ModelState& commanded = everything_.pictures[each.pictures.front()].nominal;
      for (std::size_t i = 0; i < joints().size(); ++i) {
        const AngleReading reading = read(commanded.angle(joints()[i]));
        angles[eigenIndex(i)] = reading.raw - truth[eigenIndex(i)];
        reported[eigenIndex(i)] = reading.reported;
      }
      for (const std::size_t index : each.pictures) {
        ImageObservation& picture = taken.pictures[index];
        for (const auto& [joint, i] : driven_) {
          picture.nominal.angle(joint) = picture.instant.q[eigenIndex(joint)] = reported[i];
        }
        look(everything_.pictures[index], angles, truth, picture);
      }
    }
  }
  if (pixel > 0) {
    addCornerNoise(pixel, chance, taken);
  }
}

void ThesisExperiment::addCornerNoise(double pixel, RandomStream& chance, Measurements& taken) const {
  for (const PoseGroup& pose : everything_.poses) {
    const RandomStream first = chance;
    for (const EncoderSample& sample : pose.readings) {
      if (tested_) { // the program's samples differ by joint noise only
        chance = first;
      }
      for (const std::size_t index : sample.pictures) {
        addNoise(taken.pictures[index], pixel, chance);
      }
    }
  }
}

Model makeExperimentModel(const ThesisExperiment& stage, double offsetSigma, double mountSigma) {
  Model result;
  for (Term term : stage.model().terms()) {
    for (Unknown& unknown : term.effect.unknowns) {
      if (!term.isPlacement) {
        unknown.sigma = term.effect.placeKind == PlaceKind::camera ? mountSigma : offsetSigma;
      }
    }
    result.add(std::move(term));
  }
  return result;
}

} // namespace naocal
