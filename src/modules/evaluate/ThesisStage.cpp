#include "evaluate/ThesisStage.hpp"

#include "evaluate/ThesisScenery.hpp"
#include "geometry/Index.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace naocal {

namespace {

/// Measurements in the poses, in each of which everything is to be seen.
Measurements everythingInSight(const Robot& robot, const ThesisScenery& scenery,
                               const std::vector<Eigen::VectorXd>& poses, std::size_t samples) {
  CaptureSet set{.name = "thesis", .model = robot.model, .cameras = scenery.cameras, .boards = scenery.targets};
  set.stances = {{0, SupportFoot::left, Placement{}}};
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
    for (std::size_t sample = 0; sample < samples; ++sample) {
      for (const auto& [camera, lens] : scenery.cameras) {
        Capture& capture = set.captures.emplace_back();
        capture.id = static_cast<int>(set.captures.size());
        capture.pose = fmt::format("P{:04}", pose);
        capture.repeat = static_cast<int>(sample);
        capture.repeatKind = RepeatKind::reapproach; // so that each sample's readings have errors of their own
        capture.camera = camera;
        capture.joints.measured.assign(poses[pose].begin(), poses[pose].end());
        capture.corners = all;
      }
    }
  }
  return measurementsOf({set}, robot);
}

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

ThesisStage::ThesisStage(const Robot& robot, ThesisFeature feature, const std::vector<Eigen::VectorXd>& poses,
                         std::size_t samples)
    : scenery_{thesisScenery(feature)}, everything_{everythingInSight(robot, scenery_, poses, samples)} {}

std::vector<std::string> ThesisStage::jointNames() const {
  std::vector<std::string> names;
  for (const std::size_t joint : joints()) {
    names.push_back(everything_.robot.joints[joint].name);
  }
  return names;
}

/// Fills `seen` with what its camera shows when the stage's joints truly are at these angles.
void ThesisStage::look(const Picture& all, const Eigen::VectorXd& angles, Picture& seen) const {
  thread_local Posture torsoFromLink;
  thread_local ProjectedBlocks projected;
  thread_local BoardCorners corners;
  const Robot& robot = everything_.robot;
  Belief truth = all.drawn;
  for (std::size_t i = 0; i < joints().size(); ++i) {
    truth.angle(joints()[i]) = angles[at(i)];
  }
  posture(robot, truth, all.sightings.front().view.links(), torsoFromLink);
  Attitude attitude = all.sightings.front().view.pathAttitude(robot, truth, torsoFromLink);
  const CameraIntrinsics& lens = scenery_.cameras.at(robot.cameras[all.camera].name);
  seen.sightings.clear();
  for (const Sighting& sighting : all.sightings) {
    sighting.view.placeBoard(placed(truth.boardPlacement(sighting.view.board())), attitude);
    if (!sighting.view.project(attitude, truth, sighting.corners, projected)) {
      continue;
    }
    const Board& target = everything_.targets[sighting.view.board()].board;
    findSeen(target, attitude, projected, lens, scenery_.limits, corners);
    if (!corners.ids.empty()) {
      seen.sightings.push_back({sighting.view, cornerBlocks(target, corners), corners.ids});
    }
  }
}

void ThesisStage::take(const Eigen::VectorXd& offsets, const std::function<AngleReading(double)>& read, double pixel,
                       Randomness& chance, Measurements& taken) const {
  Eigen::VectorXd angles{offsets.size()};
  for (const PoseGroup& pose : everything_.poses) {
    for (const Reading& each : pose.readings) {
      const Belief& commanded = everything_.pictures[each.pictures.front()].drawn;
      for (std::size_t i = 0; i < joints().size(); ++i) {
        const AngleReading reading = read(commanded.angle(joints()[i]));
        angles[at(i)] = reading.raw - offsets[at(i)];
        for (const std::size_t index : each.pictures) {
          Picture& picture = taken.pictures[index];
          picture.drawn.angle(joints()[i]) = picture.instant.q[at(joints()[i])] = reading.reported;
        }
      }
      for (const std::size_t index : each.pictures) {
        look(everything_.pictures[index], angles, taken.pictures[index]);
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

Model offsetModel(const ThesisStage& stage, double sigma) {
  Effect offset = jointOffset();
  offset.unknowns.front().sigma = sigma;
  return makeModel(stage.everything(), {}, {}, {offset});
}

} // namespace naocal
