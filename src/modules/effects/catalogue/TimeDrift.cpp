#include "effects/Catalogue.hpp"

namespace naocal {

/// The joint drifts during the captures. 1e-5 rad/s: a third of a degree in ten minutes.
Effect timeDrift() {
  return {
      .name = "timeDrift",
      .description = "the joint's angle creeps while the captures are taken",
      .formula = "+k * (t - t_first)",
      .placeKind = PlaceKind::motor,
      .unknowns = {{"k", "rad/s", 1e-5}},
      .drivers = {Driver::time},
      .correct = [](ModelState& modelState, const RobotSample& instant, std::size_t joint,
                    std::span<const double> values) { modelState.angle(joint) += values[0] * instant.time.count(); }};
}

} // namespace naocal
