#include "effects/Catalogue.hpp"
#include "math/RigidTransform.hpp"

namespace naocal {

/// The bearing gives way about the two normals of the joint's axis, before the joint's own turn. 0.01 rad/Nm: as
/// `elasticity`.
Effect lateralElasticity() {
  return {.name = "lateralElasticity",
          .description = "the joint's bearing gives way sideways under load",
          .formula = "parentFromJoint * R_n1(c1 * tau1) * R_n2(c2 * tau2)",
          .placeKind = PlaceKind::joint,
          .unknowns = {{"c1", "rad/Nm", 0.01}, {"c2", "rad/Nm", 0.01}},
          .drivers = {Driver::lateral1, Driver::lateral2},
          .linear = false,
          .needsUrdf = true,
          .correct = [](ModelState& modelState, const RobotSample& instant, std::size_t joint,
                        std::span<const double> values) {
            const auto at = static_cast<Eigen::Index>(joint);
            const auto [n1, n2] = bearingNormals(modelState.axis(joint));
            auto step = modelState.linkStep(joint);
            step.tail<3>() = turnsAboutXyz(rotationX(step[3]) * rotationY(step[4]) * rotationZ(step[5]) *
                                           rotationAbout(values[0] * instant.lateralTorque(0, at) * n1) *
                                           rotationAbout(values[1] * instant.lateralTorque(1, at) * n2));
          }};
}

} // namespace naocal
