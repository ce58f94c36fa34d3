#include "effects/Catalogue.hpp"

namespace naocal {

/// Rows are exposed one after the other while the joints move. 6e-5 s: the 480 rows of a NAO's camera take about 30 ms,
/// the whole period of a picture.
Effect rollingShutter() {
  return {.name = "rollingShutter",
          .description = "the picture's rows are exposed one after the other while the joints move",
          .formula = "+q' * s * (v - cy) on every joint",
          .placeKind = PlaceKind::camera,
          .unknowns = {{"s", "s/row", 6e-5}},
          .drivers = {Driver::velocity},
          .correct = [](ModelState& modelState, const RobotSample&, std::size_t, std::span<const double> values) {
            modelState.rowTime() += values[0];
          }};
}

} // namespace naocal
