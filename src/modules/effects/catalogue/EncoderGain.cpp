#include "effects/Catalogue.hpp"

namespace naocal {

/// The encoder's gain is wrong, for example with a magnet too high or too low. 1 %: specification of magnetic encoders.
Effect encoderGain() {
  return {.name = effectName::encoderGain,
          .description = "the encoder counts too much or too little per turn",
          .formula = "+g * q",
          .placeKind = PlaceKind::motor,
          .unknowns = {{"g", "1", 0.01}},
          .drivers = {Driver::angle},
          .correct = [](ModelState& modelState, const RobotSample& instant, std::size_t joint,
                        std::span<const double> values) {
            modelState.angle(joint) += values[0] * instant.q[static_cast<Eigen::Index>(joint)];
          }};
}

} // namespace naocal
