#include "effects/Catalogue.hpp"

namespace naocal {

/// Gear and link expand with the motor's temperature. 5e-4 rad/K: a degree over the 35 K that a leg motor warms up in a
/// game.
Effect thermalDrift() {
  return {.name = "thermalDrift",
          .description = "the joint's angle drifts as its motor warms up",
          .formula = "+k * (T - 30 degC)",
          .placeKind = PlaceKind::motor,
          .unknowns = {{"k", "rad/K", 5e-4}},
          .drivers = {Driver::temperature},
          .correct = [](ModelState& modelState, const RobotSample& instant, std::size_t joint,
                        std::span<const double> values) {
            modelState.angle(joint) += values[0] * (instant.temperature[static_cast<Eigen::Index>(joint)] - 30);
          }};
}

} // namespace naocal
