#include "effects/Catalogue.hpp"

namespace naocal {

/// A link is longer than nominal, equally on both sides. 2 mm: tolerance of moulded and screwed plastic parts.
Effect linkLength() {
  return {.name = "linkLength",
          .description = "a link is longer or shorter than the drawing says",
          .formula = "length + dL",
          .placeKind = PlaceKind::length,
          .unknowns = {{"dL", "m", 0.002}},
          .correct = [](ModelState& modelState, const RobotSample&, std::size_t length,
                        std::span<const double> values) { modelState.length(length) += values[0]; }};
}

} // namespace naocal
