#include "effects/Catalogue.hpp"

#include <algorithm>
#include <cmath>

namespace naocal {

/// Gear and link deflect like a spring behind the encoder, in equilibrium with the torque at the deflected angle. As a
/// function of its own angle a joint's torque is a sine, tau(q + delta) = tau cos(delta) + tau' sin(delta). 0.01
/// rad/Nm: half a degree to a degree in the legs of a standing NAO, which carry 1 to 4 Nm, and a tenth more for tau' =
/// 10 Nm/rad.
Effect elasticity() {
  return {.name = effectName::elasticity,
          .alias = "spring",
          .description = "the joint gives way under load like a spring",
          .formula = "+delta, delta = c * tau(q + delta)",
          .placeKind = PlaceKind::motor,
          .unknowns = {{"c", "rad/Nm", 0.01}},
          .drivers = {Driver::torque, Driver::torqueGrowth},
          .linear = false,
          .correct = [](ModelState& modelState, const RobotSample& instant, std::size_t joint,
                        std::span<const double> values) {
            const auto at = static_cast<Eigen::Index>(joint);
            const double torque = instant.torque[at], growth = instant.torqueGrowth[at];
            double delta = 0;
            for (int step = 0; step < 6; ++step) { // Newton; the slope is limited where no spring could hold the joint
              const double missing = delta - values[0] * (torque * std::cos(delta) + growth * std::sin(delta));
              const double slope = 1 - values[0] * (growth * std::cos(delta) - torque * std::sin(delta));
              delta -= missing / std::max(0.3, slope);
            }
            modelState.angle(joint) += delta;
          }};
}

} // namespace naocal
