#include "synthetic/CornerMeasurement.hpp"

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
  constexpr std::size_t enough = 8;
  std::vector<DisplacedBoard> candidates;
  const auto corners = cornersInView(walk, plan);
  for (std::size_t capture = 0; capture < corners.size(); ++capture) {
    for (const BoardCorners& board : corners[capture]) {
      if (board.ids.size() >= enough) {
        candidates.push_back({walk.captures[capture].id, board.board, 0, 0});
      }
    }
  }
  if (candidates.empty()) {
    return std::nullopt;
  }
  DisplacedBoard displaced = candidates[chance.below(candidates.size())];
  const Eigen::Vector2d shift = chance.direction(distance);
  displaced.x = shift.x();
  displaced.y = shift.y();
  for (std::size_t board = 0; board < plan.boards.size(); ++board) {
    if (plan.boards[board].id == displaced.board) {
      walk.exposures[static_cast<std::size_t>(displaced.capture)].worldFromBoard[board].translate(
          Eigen::Vector3d{shift.x(), shift.y(), 0});
    }
  }
  return displaced;
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
