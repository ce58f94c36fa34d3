#include "synthetic/CornerMeasurement.hpp"

#include <algorithm>

namespace naocal {

namespace {

std::vector<BoardCorners> cornersInView(const Capture& capture, const Exposure& exposure, const SimulationPlan& plan) {
  std::vector<BoardCorners> seen;
  for (std::size_t board = 0; board < plan.boards.size(); ++board) {
    BoardCorners corners = visibleCorners(plan.cameras.at(capture.camera), plan.boards[board],
                                          exposure.worldFromCamera.inverse() * exposure.worldFromBoard[board]);
    if (!corners.ids.empty()) {
      seen.push_back(std::move(corners));
    }
  }
  return seen;
}

/// A board in a picture that shows enough of it to find its pose.
struct Appearance {
  std::size_t capture, board;
};

std::vector<Appearance> goodSights(const Walk& walk, const SimulationPlan& plan) {
  constexpr std::size_t enough = 8; // corners
  std::vector<Appearance> sights;
  for (std::size_t capture = 0; capture < walk.captures.size(); ++capture) {
    for (const BoardCorners& corners : cornersInView(walk.captures[capture], walk.exposures[capture], plan)) {
      const auto board = std::find_if(plan.boards.begin(), plan.boards.end(),
                                      [&](const Board& candidate) { return candidate.id == corners.board; });
      if (corners.ids.size() >= enough) {
        sights.push_back({capture, static_cast<std::size_t>(board - plan.boards.begin())});
      }
    }
  }
  return sights;
}

} // namespace

std::vector<std::vector<BoardCorners>> cornersInView(const Walk& walk, const SimulationPlan& plan) {
  std::vector<std::vector<BoardCorners>> corners;
  for (std::size_t capture = 0; capture < walk.captures.size(); ++capture) {
    corners.push_back(cornersInView(walk.captures[capture], walk.exposures[capture], plan));
  }
  return corners;
}

std::optional<DisplacedBoard> displaceOneBoard(Walk& walk, const SimulationPlan& plan, double distance,
                                               Randomness& chance) {
  std::vector<Appearance> candidates = goodSights(walk, plan);
  while (!candidates.empty()) {
    const auto chosen = candidates.begin() + static_cast<std::ptrdiff_t>(chance.below(candidates.size()));
    const Appearance sight = *chosen;
    candidates.erase(chosen);
    const Eigen::Vector2d shift = chance.direction(distance);
    Eigen::Isometry3d& worldFromBoard = walk.exposures[sight.capture].worldFromBoard[sight.board];
    const Eigen::Isometry3d before = worldFromBoard;
    worldFromBoard.translate(Eigen::Vector3d{shift.x(), shift.y(), 0});
    const std::vector<Appearance> after = goodSights(walk, plan);
    const auto others = std::count_if(after.begin(), after.end(), [&](const Appearance& other) {
      return other.board == sight.board && other.capture != sight.capture;
    });
    const bool stillSeen = std::any_of(after.begin(), after.end(), [&](const Appearance& other) {
      return other.board == sight.board && other.capture == sight.capture;
    });
    if (stillSeen && others >= 2) {
      return DisplacedBoard{walk.captures[sight.capture].id, plan.boards[sight.board].id, shift.x(), shift.y()};
    }
    worldFromBoard = before;
  }
  return std::nullopt;
}

std::vector<GrossCorner> spoil(std::vector<Capture>& captures, const CornerNoise& noise, Randomness& chance) {
  std::vector<GrossCorner> gross;
  const auto error = [&] { return noise.heavyTails ? chance.heavyTailed(noise.pixel) : chance.normal(noise.pixel); };
  for (Capture& capture : captures) {
    for (BoardCorners& board : *capture.corners) {
      for (std::size_t i = 0; i < board.ids.size(); ++i) {
        const double errorU = error(), errorV = error();
        board.uv[i] += Eigen::Vector2d{errorU, errorV};
        if (chance.chance(noise.grossShare)) {
          board.uv[i] += chance.direction(noise.grossSize);
          gross.push_back({capture.id, board.board, board.ids[i]});
        }
      }
    }
  }
  return gross;
}

} // namespace naocal
