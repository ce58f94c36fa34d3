#include "effects/Catalogue.hpp"

namespace naocal {

/// The camera is rotated in the head: nominal mount * Rx(rx) Ry(ry) Rz(rz), axes x forward, y left, z up.
Effect cameraRotation() {
  return {.name = effectName::cameraRotation,
          .description = "the camera sits turned in the head",
          .formula = "headFromCamera = nominal * Rx(rx) * Ry(ry) * Rz(rz)",
          .placeKind = PlaceKind::camera,
          .unknowns = {{"rx", "rad", 0.05}, {"ry", "rad", 0.05}, {"rz", "rad", 0.05}},
          .inBaseModel = true,
          .correct = [](ModelState& modelState, const RobotSample&, std::size_t, std::span<const double> values) {
            modelState.mountRotation() += Eigen::Vector3d{values[0], values[1], values[2]};
          }};
}

} // namespace naocal
