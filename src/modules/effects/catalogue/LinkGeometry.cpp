#include "effects/Catalogue.hpp"

namespace naocal {

/// The drawing's fixed step to a joint is off. 5 mm and 0.02 rad: printed or bolted parts, and drawings of other
/// versions.
Effect linkGeometry() {
  return {.name = effectName::linkGeometry,
          .description = "the part before the joint is not as the drawing says",
          .formula = "parentFromJoint * T(x, y, z) * Rx(rx) * Ry(ry) * Rz(rz)",
          .placeKind = PlaceKind::joint,
          .unknowns = {{"x", "m", 0.005},
                       {"y", "m", 0.005},
                       {"z", "m", 0.005},
                       {"rx", "rad", 0.02},
                       {"ry", "rad", 0.02},
                       {"rz", "rad", 0.02}},
          .needsUrdf = true,
          .correct = [](ModelState& modelState, const RobotSample&, std::size_t joint, std::span<const double> values) {
            for (std::size_t i = 0; i < values.size(); ++i) {
              modelState.linkStep(joint)[static_cast<Eigen::Index>(i)] += values[i];
            }
          }};
}

} // namespace naocal
