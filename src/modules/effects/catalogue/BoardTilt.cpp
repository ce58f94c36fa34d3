#include "effects/Catalogue.hpp"

namespace naocal {

/// The board does not lie flat on the floor. 0.01 rad: 6 mm under one end of an A2 board.
Effect boardTilt() {
  return {.name = "boardTilt",
          .description = "the board does not lie flat",
          .formula = "worldFromBoard = placement * Ry(pitch) * Rx(roll)",
          .placeKind = PlaceKind::board,
          .unknowns = {{"roll", "rad", 0.01}, {"pitch", "rad", 0.01}},
          .correct = [](ModelState& modelState, const RobotSample&, std::size_t board, std::span<const double> values) {
            modelState.boardPlacement(board).segment<2>(3) += Eigen::Vector2d{values[0], values[1]};
          }};
}

} // namespace naocal
