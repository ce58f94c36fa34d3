#include "effects/Catalogue.hpp"

namespace naocal {

/// The body tips over the foot that carries it, the more the farther its centre of mass is from the sole frame. 0.3
/// rad/m: half a degree for 3 cm. On both feet the share of either is not told: single support only.
Effect soleCompliance() {
  return {.name = "soleCompliance",
          .what = "the sole or the floor gives way: the body tips towards its centre of mass",
          .formula = "pitch + c * com_x, roll - c * com_y",
          .place = EffectSite::sole,
          .unknowns = {{"c", "rad/m", 0.3}},
          .needs = {Driver::com},
          .correct = [](ModelState& belief, const RobotSample& instant, std::size_t, std::span<const double> values) {
            if (instant.supportFoot != SupportFoot::both) {
              belief.worldFromSupport()[3] -= values[0] * instant.com.y();
              belief.worldFromSupport()[4] += values[0] * instant.com.x();
            }
          }};
}

} // namespace naocal
