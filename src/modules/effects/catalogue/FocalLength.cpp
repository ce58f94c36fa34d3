#include "effects/Catalogue.hpp"

namespace naocal {

/// Both focal lengths have the same relative error: fx, fy times (1 + s).
Effect focalLength() {
  return {.name = "focalLength",
          .description = "the lens magnifies more or less than the file says",
          .formula = "fx, fy -> fx (1 + s), fy (1 + s)",
          .placeKind = PlaceKind::camera,
          .unknowns = {{"s", "1", 0.03}},
          .correct = [](ModelState& modelState, const RobotSample&, std::size_t, std::span<const double> values) {
            modelState.lens().head<2>() *= 1 + values[0];
          }};
}

} // namespace naocal
