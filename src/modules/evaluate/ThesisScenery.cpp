#include "evaluate/ThesisScenery.hpp"

#include "math/LinearAlgebra.hpp"
#include "robot/Balance.hpp"
#include "synthetic/SimulationPlan.hpp"

#include <fmt/format.h>
#include <numeric>

namespace naocal {

namespace {

/// Floor points every quarter of a metre up to 4 m away, square metres of them.
std::vector<Board> floorTiles() {
  constexpr int perMetre = 4, farthest = 4;
  std::vector<Board> tiles;
  for (int x = 0; x < farthest; ++x) {
    for (int y = -farthest; y < farthest; ++y) {
      Board tile;
      tile.id = fmt::format("{}{:+}", x, y);
      tile.placement = Placement{static_cast<double>(x), static_cast<double>(y)};
      for (int i = 0; i < perMetre * perMetre; ++i) {
        const Eigen::Vector3d point{(i % perMetre + 0.5) / perMetre, (i / perMetre + 0.5) / perMetre, 0};
        if (Eigen::Vector2d{x + point.x(), y + point.y()}.norm() <= farthest) {
          tile.points.push_back(point);
        }
      }
      if (!tile.points.empty()) {
        tiles.push_back(tile);
      }
    }
  }
  return tiles;
}

} // namespace

ThesisScenery thesisScenery(ThesisFeature feature) {
  ThesisScenery result{{}, drawnCameras(640, 480), {}};
  if (feature == ThesisFeature::grid) {
    result.targets = floorTiles();
    result.limits.farthest = 4.5; // from the camera, half a metre over the floor
    result.limits.grazing = radians(5);
    result.limits.corners = 1;
    return result;
  }
  result.targets = boardsAround();
  for (Board& board : result.targets) { // seen from the sole
    board.placement->y -= halfStance;
  }
  return result;
}

Measurements everythingInSight(const Robot& robot, const ThesisScenery& scenery, const ThesisSetting& setting,
                               const std::vector<ThesisPose>& poses) {
  CaptureSet set{.name = "thesis", .model = robot.model, .cameras = scenery.cameras, .boards = scenery.targets};
  set.stances = {{0, SupportFoot::left, Placement{}}, {1, SupportFoot::right, Placement{.y = -betweenFeet}}};
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
        capture.repeatKind = RepeatKind::reapproach; // so that each sample's readings have errors of their own
        capture.camera = camera;
        capture.supportFoot = poses[pose].foot;
        capture.stance = poses[pose].foot == SupportFoot::left ? 0 : 1;
        capture.joints.measured.assign(poses[pose].angles.begin(), poses[pose].angles.end());
        capture.corners = all;
      }
    }
  }
  return measurementsOf({set}, robot);
}

} // namespace naocal
