#include "effects/Catalogue.hpp"

namespace naocal {

/// The print differs from its nominal size. 1 %: typical of office printers and page scaling.
Effect boardScale() {
  return {.name = "boardScale",
          .description = "the board was printed larger or smaller than the file says",
          .formula = "squareLength * (1 + s)",
          .placeKind = PlaceKind::board,
          .unknowns = {{"s", "1", 0.01}},
          .shared = true,
          .correct = [](ModelState& modelState, const RobotSample&, std::size_t board, std::span<const double> values) {
            modelState.boardScale(board) += values[0];
          }};
}

} // namespace naocal
