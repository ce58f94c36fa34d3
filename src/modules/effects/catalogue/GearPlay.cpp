#include "effects/Catalogue.hpp"

#include <cmath>

namespace naocal {

/// The side of the gap is gravity's where its torque exceeds the gear's friction, and the last motion's where not. A
/// NAO's gears stick up to 0.05 to 0.5 Nm: t counts from 0.2 Nm, where fits begin, and friction rounds both steps.
Effect gearPlay() {
  return {
      .name = "gearPlay",
      .what = "the gear's gap: load holds the joint at one end of it, or the last motion does",
      .formula = "+(D/2) * s, s = sgn(tau) where |tau| > 0.2 Nm + t, else -approach",
      .place = EffectSite::motor,
      .unknowns = {{"D", "rad", 0.01}, {"t", "Nm", 0.1}},
      .needs = {Driver::torque, Driver::approach},
      .limits = {{"backlash", "t", 0.05 - gearFriction}, {"hysteresis", "t", 0.5 - gearFriction}},
      .linear = false,
      .kink = true,
      .correct = [](ModelState& belief, const RobotSample& instant, std::size_t joint, std::span<const double> values) {
        const auto at = static_cast<Eigen::Index>(joint);
        const double torque = instant.torque[at], excess = std::abs(torque) - gearFriction - values[1];
        const double held = (1 + std::tanh(excess / 0.03)) / 2; // by load; the rest by the last motion
        belief.angle(joint) += values[0] / 2 * (held * std::tanh(torque / 0.03) - (1 - held) * instant.approach[at]);
      }};
}

} // namespace naocal
