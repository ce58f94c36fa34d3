#include "effects/Catalogue.hpp"

namespace naocal {

/// The lens is tilted over the sensor: added to the given p1, p2.
Effect tangentialDistortion() {
  return {.name = "tangentialDistortion",
          .description = "the lens sits tilted over the sensor",
          .formula = "p1, p2 -> p1 + p1', p2 + p2'",
          .placeKind = PlaceKind::camera,
          .unknowns = {{"p1", "1", 0.01}, {"p2", "1", 0.01}},
          .correct = [](ModelState& modelState, const RobotSample&, std::size_t, std::span<const double> values) {
            modelState.lens().segment<2>(6) += Eigen::Vector2d{values[0], values[1]};
          }};
}

} // namespace naocal
