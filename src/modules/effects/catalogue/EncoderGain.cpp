#include "effects/Catalogue.hpp"

namespace naocal {

/// The encoder counts too much or too little per turn: a magnet that sits too high or low. 1 % is what magnetic
/// encoders are specified to.
Effect encoderGain() {
  return {
      .name = "encoderGain",
      .what = "the encoder counts too much or too little per turn",
      .formula = "+g * q",
      .place = EffectSite::motor,
      .unknowns = {{"g", "1", 0.01}},
      .needs = {Driver::angle},
      .correct = [](ModelState& belief, const RobotSample& instant, std::size_t joint, std::span<const double> values) {
        belief.angle(joint) += values[0] * instant.q[static_cast<Eigen::Index>(joint)];
      }};
}

} // namespace naocal
