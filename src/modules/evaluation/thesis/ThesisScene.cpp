#include "evaluation/thesis/ThesisScene.hpp"

#include "math/Angles.hpp"
#include "math/LinearAlgebra.hpp"
#include "robot/Balance.hpp"
#include "simulation/SimulationPlan.hpp"

#include <fmt/format.h>
#include <utility>

namespace naocal {

namespace {

/// Floor points every 0.25 m up to 4 m away, in tiles of one square metre.
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

/// A pattern of floor points as a target.
Board asTarget(const FloorPattern& pattern, std::string id) {
  Board target;
  target.id = std::move(id);
  target.placement = Placement{pattern.x, pattern.y, 0, 0, 0, pattern.yaw};
  const Eigen::Matrix2Xd points = pattern.points();
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    target.points.emplace_back(points(0, i), points(1, i), 0);
  }
  return target;
}

} // namespace

ThesisScene makeProgramScene(const std::vector<FloorPattern>& patterns) {
  ThesisScene result{{}, {{"bottom", nominalCameras(640, 480).at("bottom")}}, {}, true};
  for (const FloorPattern& pattern : patterns) {
    result.targets.push_back(asTarget(pattern, fmt::format("pattern {}", result.targets.size() + 1)));
  }
  result.limits.nearest = 0;
  result.limits.farthest = 100;
  result.limits.grazing = 0;
  result.limits.border = 0;
  result.limits.corners = 1;
  return result;
}

ThesisScene makeThesisScene(ThesisFeature feature, const std::vector<FloorPattern>& patterns) {
  if (feature == ThesisFeature::file) {
    return makeProgramScene(patterns);
  }
  if (feature == ThesisFeature::programGrid) {
    return makeProgramScene({programGrid()});
  }
  if (feature == ThesisFeature::fourBoards || feature == ThesisFeature::eightBoards) {
    return makeProgramScene({programBoard()});
  }
  ThesisScene result{{}, nominalCameras(640, 480), {}};
  if (feature == ThesisFeature::grid) {
    result.targets = floorTiles();
    result.limits.farthest = 4.5; // [m] from the camera, which is 0.5 m above the floor
    result.limits.grazing = radians(5);
    result.limits.corners = 1;
    return result;
  }
  result.targets = defaultBoards();
  for (Board& board : result.targets) { // relative to the sole
    board.placement->y -= halfFootDistance;
  }
  return result;
}

std::size_t copiesOf(ThesisFeature feature) {
  return feature == ThesisFeature::fourBoards ? 4 : feature == ThesisFeature::eightBoards ? 8 : 1;
}

} // namespace naocal
