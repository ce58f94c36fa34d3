#include "effects/Catalogue.hpp"

#include <cmath>

namespace naocal {

/// The side of the gap follows gravity where its torque exceeds the gear's friction, otherwise the last motion.
/// Friction of NAO gears is 0.05 to 0.5 Nm; t is relative to 0.2 Nm, the start of fits. Friction smooths both steps.
Effect gearPlay() {
  return {.name = effectName::gearPlay,
          .description = "the gear's gap: load holds the joint at one end of it, or the last motion does",
          .formula = "+(D/2) * s, s = sgn(tau) where |tau| > 0.2 Nm + t, else -approach",
          .placeKind = PlaceKind::motor,
          .unknowns = {{"D", "rad", 0.01}, {"t", "Nm", 0.1}},
          .drivers = {Driver::torque, Driver::approach},
          .limits = {{"backlash", "t", 0.05 - gearFriction}, {"hysteresis", "t", 0.5 - gearFriction}},
          .linear = false,
          .kink = true,
          .correct = [](ModelState& modelState, const RobotSample& instant, std::size_t joint,
                        std::span<const double> values) {
            const auto at = static_cast<Eigen::Index>(joint);
            const double torque = instant.torque[at], excess = std::abs(torque) - gearFriction - values[1];
            const double held =
                (1 + std::tanh(excess / 0.03)) / 2; // share held by the load; the rest by the last motion
            modelState.angle(joint) +=
                values[0] / 2 * (held * std::tanh(torque / 0.03) - (1 - held) * instant.approach[at]);
          }};
}

} // namespace naocal
