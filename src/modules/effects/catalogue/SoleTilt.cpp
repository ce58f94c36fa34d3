#include "effects/Catalogue.hpp"

namespace naocal {

/// The body stands on that sole at a constant tilt: a bent foot, worn rubber, a slope. 0.02 rad: 3 mm over the length
/// of a sole.
Effect soleTilt() {
  return {.name = "soleTilt",
          .description = "the body stands tilted on that sole: a bent foot or a slope",
          .formula = "worldFromSole = placement * Ry(pitch) * Rx(roll)",
          .placeKind = PlaceKind::sole,
          .unknowns = {{"roll", "rad", 0.02}, {"pitch", "rad", 0.02}},
          .correct = [](ModelState& modelState, const RobotSample&, std::size_t, std::span<const double> values) {
            modelState.worldFromSupport().segment<2>(3) += Eigen::Vector2d{values[0], values[1]};
          }};
}

} // namespace naocal
