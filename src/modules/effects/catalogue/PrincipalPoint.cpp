#include "effects/Catalogue.hpp"

namespace naocal {

/// The optical axis meets the sensor elsewhere: cx, cy are shifted.
Effect principalPoint() {
  return {.name = "principalPoint",
          .description = "the optical axis meets the sensor elsewhere than the file says",
          .formula = "cx, cy -> cx + x, cy + y",
          .placeKind = PlaceKind::camera,
          .unknowns = {{"x", "px", 20}, {"y", "px", 20}},
          .correct = [](ModelState& modelState, const RobotSample&, std::size_t, std::span<const double> values) {
            modelState.lens().segment<2>(2) += Eigen::Vector2d{values[0], values[1]};
          }};
}

} // namespace naocal
