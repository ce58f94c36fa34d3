#include "effects/Catalogue.hpp"

#include <cmath>

namespace naocal {

/// Gravity holds the gear at one end of its gap; friction smooths the step: sgn(tau) = tanh(tau / 0.03 Nm). NAO gears
/// have gaps of several tenths of a degree.
Effect backlash() {
  return {.name = "backlash",
          .description = "the gear's gap: gravity holds the joint at one end of it",
          .formula = "+(D/2) * sgn(tau)",
          .placeKind = PlaceKind::motor,
          .unknowns = {{"D", "rad", 0.01}},
          .drivers = {Driver::torque},
          .kink = true,
          .correct = [](ModelState& modelState, const RobotSample& instant, std::size_t joint,
                        std::span<const double> values) {
            modelState.angle(joint) +=
                values[0] / 2 * std::tanh(instant.torque[static_cast<Eigen::Index>(joint)] / 0.03);
          }};
}

} // namespace naocal
