#include "effects/AllEffects.hpp"

namespace naocal {

/// Gear and link give way like a spring behind the encoder. 0.01 rad/Nm: half a degree to a degree in the legs of a
/// standing NAO, which carry 1 to 4 Nm.
Effect elasticity() {
  return {.name = "elasticity",
          .what = "the joint gives way under load like a spring",
          .formula = "+c * tau",
          .place = Place::motor,
          .unknowns = {{"c", "rad/Nm", 0.01}},
          .needs = {Driver::torque},
          .correct = [](Belief& belief, const Instant& instant, std::size_t joint, std::span<const double> values) {
            belief.angle(joint) += values[0] * instant.torque[static_cast<Eigen::Index>(joint)];
          }};
}

} // namespace naocal
