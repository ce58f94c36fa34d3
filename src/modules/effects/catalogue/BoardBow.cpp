#include "effects/Catalogue.hpp"

namespace naocal {

/// The sheet is bent: its middle is higher than its rim. 3 mm: a loose A2 sheet.
Effect boardBow() {
  return {.name = "boardBow",
          .description = "the board is bent: its middle stands higher than its rim",
          .formula = "z = h * (1 - (r / r_max)^2)",
          .placeKind = PlaceKind::board,
          .unknowns = {{"h", "m", 0.003}},
          .correct = [](ModelState& modelState, const RobotSample&, std::size_t board, std::span<const double> values) {
            modelState.boardBow(board) += values[0];
          }};
}

} // namespace naocal
