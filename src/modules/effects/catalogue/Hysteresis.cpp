#include "effects/Catalogue.hpp"

namespace naocal {

/// The output lags the last motion by half the gap (Adikari's thesis, equation 3.1).
Effect hysteresis() {
  return {.name = effectName::hysteresis,
          .description = "the gear's gap: the joint lags behind its last motion",
          .formula = "-(D/2) * approach",
          .placeKind = PlaceKind::motor,
          .unknowns = {{"D", "rad", 0.01}},
          .drivers = {Driver::approach},
          .kink = true,
          .correct = [](ModelState& modelState, const RobotSample& instant, std::size_t joint,
                        std::span<const double> values) {
            modelState.angle(joint) -= values[0] / 2 * instant.approach[static_cast<Eigen::Index>(joint)];
          }};
}

} // namespace naocal
