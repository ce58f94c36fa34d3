#include "effects/Catalogue.hpp"

namespace naocal {

/// Coupled drives: the joint turns along with the next recorded joint towards the base. 1 %: a gear's worth of a belt
/// or a cable that runs through that joint.
Effect motorCoupling(std::size_t other) {
  return {.name = effectName::motorCoupling,
          .description = "the joint turns along with the one before it",
          .formula = "+k * q of the next recorded joint towards the base",
          .placeKind = PlaceKind::motor,
          .unknowns = {{"k", "1", 0.01}},
          .remoteDrivers = {{Driver::angle, other}},
          .needsUrdf = true,
          .correct = [other](ModelState& modelState, const RobotSample& instant, std::size_t joint,
                             std::span<const double> values) {
            modelState.angle(joint) += values[0] * instant.q[static_cast<Eigen::Index>(other)];
          }};
}

} // namespace naocal
