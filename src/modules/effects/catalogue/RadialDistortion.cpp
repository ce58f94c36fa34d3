#include "effects/Catalogue.hpp"

namespace naocal {

/// Radial distortion, added to the given k1, k2.
Effect radialDistortion() {
  return {.name = "radialDistortion",
          .description = "the lens bends rays more or less towards its rim than the file says",
          .formula = "k1, k2 -> k1 + k1', k2 + k2'",
          .placeKind = PlaceKind::camera,
          .unknowns = {{"k1", "1", 0.1}, {"k2", "1", 0.2}},
          .correct = [](ModelState& modelState, const RobotSample&, std::size_t, std::span<const double> values) {
            modelState.lens().segment<2>(4) += Eigen::Vector2d{values[0], values[1]};
          }};
}

} // namespace naocal
