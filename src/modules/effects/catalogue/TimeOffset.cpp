#include "effects/Catalogue.hpp"

#include <cmath>

namespace naocal {

/// Pictures and angles have different time stamps: the picture is younger by dt. 20 ms: transfer of a picture and half
/// its exposure.
Effect timeOffset() {
  return {
      .name = "timeOffset",
      .description = "pictures are younger than the joint angles recorded with them",
      .formula = "+q' * dt on every joint",
      .placeKind = PlaceKind::all,
      .unknowns = {{"dt", "s", 0.02}},
      .drivers = {Driver::velocity},
      .correct = [](ModelState& modelState, const RobotSample& instant, std::size_t, std::span<const double> values) {
        for (Eigen::Index joint = 0; joint < instant.velocity.size(); ++joint) {
          if (std::isfinite(instant.velocity[joint])) {
            modelState.angle(static_cast<std::size_t>(joint)) += instant.velocity[joint] * values[0];
          }
        }
      }};
}

} // namespace naocal
