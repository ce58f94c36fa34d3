#include "effects/Catalogue.hpp"

namespace naocal {

/// The encoder's zero is off: q_true = q_measured - o. Worn and fallen NAOs show up to 11 degrees (published offsets).
Effect jointOffset() {
  return {.name = effectName::jointOffset,
          .description = "the encoder's zero is off: a fall, a worn gear, an assembly one tooth away",
          .formula = "q_true = q_measured - o",
          .placeKind = PlaceKind::motor,
          .unknowns = {{"o", "rad", 0.1}},
          .inBaseModel = true,
          .correct = [](ModelState& modelState, const RobotSample&, std::size_t joint, std::span<const double> values) {
            modelState.angle(joint) -= values[0];
          }};
}

} // namespace naocal
