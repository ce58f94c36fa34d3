#include "effects/Catalogue.hpp"
#include "math/RigidTransform.hpp"

namespace naocal {

/// The joint's axis deviates from the nominal one; no correction at q = 0. 0.01 rad: 0.3 mm over a bearing seat of 30
/// mm.
Effect axisTilt() {
  return {.name = "axisTilt",
          .description = "the joint's axis is tilted against the drawing",
          .formula = "axis = R_n1(alpha) * R_n2(beta) * drawn axis",
          .placeKind = PlaceKind::joint,
          .unknowns = {{"alpha", "rad", 0.01}, {"beta", "rad", 0.01}},
          .linear = false,
          .correct = [](ModelState& modelState, const RobotSample&, std::size_t joint, std::span<const double> values) {
            const Eigen::Vector3d axis = modelState.axis(joint);
            const auto [n1, n2] = bearingNormals(axis);
            modelState.axis(joint) = rotationAbout(values[0] * n1) * rotationAbout(values[1] * n2) * axis;
          }};
}

} // namespace naocal
