#include "effects/Catalogue.hpp"

#include <cmath>

namespace naocal {

/// The encoder's magnet rotates off centre: an error with one period per turn. 0.005 rad: 0.1 mm at a radius of 20 mm.
Effect encoderEccentricity() {
  return {.name = "encoderEccentricity",
          .description = "the encoder's magnet turns off its centre: an error with one period per turn",
          .formula = "+a * sin(q) + b * cos(q)",
          .placeKind = PlaceKind::motor,
          .unknowns = {{"a", "rad", 0.005}, {"b", "rad", 0.005}},
          .drivers = {Driver::angle},
          .correct = [](ModelState& modelState, const RobotSample& instant, std::size_t joint,
                        std::span<const double> values) {
            const double q = instant.q[static_cast<Eigen::Index>(joint)];
            modelState.angle(joint) += values[0] * std::sin(q) + values[1] * std::cos(q);
          }};
}

} // namespace naocal
