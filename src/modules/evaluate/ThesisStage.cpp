#include "evaluate/ThesisStage.hpp"

#include "evaluate/ThesisScenery.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>

namespace naocal {

namespace {

/// Which corners of a target are in sight, and where; few ones count as none.
void findSeen(const Board& target, const Attitude& attitude, const ProjectedBlocks& projected,
              const CameraIntrinsics& lens, const SightLimits& limits, BoardCorners& seen) {
  const double height = attitude.opticalFromBoard.inverse().translation.z(); // of the camera over the floor
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

} // namespace

ThesisStage::ThesisStage(const Robot& robot, const ThesisSetting& setting, const std::vector<ThesisPose>& poses)
    : scenery_{thesisScenery(setting.feature)}, everything_{everythingInSight(robot, scenery_, setting, poses)} {
  std::vector<Effect> effects{jointOffset()};
  if (setting.unknownPlaces) {
    effects.push_back(cameraRotation());
  }
  model_ = makeModel(everything_, {}, {}, effects);
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const auto motor = std::find(joints().begin(), joints().end(), robot.joints[joint].motor);
    if (motor != joints().end()) {
      driven_.emplace_back(joint, motor - joints().begin());
    }
  }
}

std::vector<std::string> ThesisStage::jointNames() const {
  std::vector<std::string> names;
  for (const std::size_t joint : joints()) {
    names.push_back(everything_.robot.joints[joint].name);
  }
  return names;
}

/// Fills `seen` with what its camera shows when the stage's joints truly are at these angles.
void ThesisStage::look(const Picture& all, const Eigen::VectorXd& angles, const Eigen::VectorXd& truth,
                       Picture& seen) const {
  thread_local Posture torsoFromLink;
  thread_local ProjectedBlocks projected;
  thread_local BoardCorners corners;
  const Robot& robot = everything_.robot;
  Belief real = all.drawn;
  for (const auto& [joint, i] : driven_) {
    real.angle(joint) = angles[i];
  }
  for (std::size_t term = joints().size(); term < model_.terms().size(); ++term) { // mounts and places
    const Term& other = model_.terms()[term];
    for (const std::size_t place : placesOn(other, everything_, all)) {
      other.effect.correct(real, all.instant, place, other.values(truth));
    }
  }
  posture(robot, real, all.sightings.front().view.links(), torsoFromLink);
  Attitude attitude = all.sightings.front().view.pathAttitude(robot, real, torsoFromLink);
  const CameraIntrinsics& lens = scenery_.cameras.at(robot.cameras[all.camera].name);
  seen.sightings.clear();
  for (const Sighting& sighting : all.sightings) {
    sighting.view.placeBoard(placed(real.boardPlacement(sighting.view.board())), attitude);
    if (!sighting.view.project(attitude, real, sighting.corners, projected)) {
      continue;
    }
    const Board& target = everything_.targets[sighting.view.board()].board;
    findSeen(target, attitude, projected, lens, scenery_.limits, corners);
    if (!corners.ids.empty()) {
      seen.sightings.push_back({sighting.view, cornerBlocks(target, corners), corners.ids});
    }
  }
}

void ThesisStage::take(const Eigen::VectorXd& truth, const std::function<AngleReading(double)>& read, double pixel,
                       Randomness& chance, Measurements& taken) const {
  Eigen::VectorXd angles{at(joints().size())}, reported = angles;
  for (const PoseGroup& pose : everything_.poses) {
    for (const Reading& each : pose.readings) {
      const Belief& commanded = everything_.pictures[each.pictures.front()].drawn;
      for (std::size_t i = 0; i < joints().size(); ++i) {
        const AngleReading reading = read(commanded.angle(joints()[i]));
        angles[at(i)] = reading.raw - truth[at(i)];
        reported[at(i)] = reading.reported;
      }
      for (const std::size_t index : each.pictures) {
        Picture& picture = taken.pictures[index];
        for (const auto& [joint, i] : driven_) {
          picture.drawn.angle(joint) = picture.instant.q[at(joint)] = reported[i];
        }
        look(everything_.pictures[index], angles, truth, picture);
      }
    }
  }
  for (Picture& picture : taken.pictures) {
    for (Sighting& sighting : picture.sightings) {
      for (CornerBlock& block : sighting.corners) {
        for (int i = 0; pixel > 0 && i < 4; ++i) {
          block.u[i] += chance.normal(pixel);
          block.v[i] += chance.normal(pixel);
        }
      }
    }
  }
}

Model unknownsOf(const ThesisStage& stage, double offsetSigma, double mountSigma) {
  Model result;
  for (Term term : stage.model().terms()) {
    for (Unknown& unknown : term.effect.unknowns) {
      if (!term.isPlacement) {
        unknown.sigma = term.effect.place == Place::camera ? mountSigma : offsetSigma;
      }
    }
    result.add(std::move(term));
  }
  return result;
}

} // namespace naocal
