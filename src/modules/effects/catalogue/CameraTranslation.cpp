#include "effects/Catalogue.hpp"

namespace naocal {

/// The camera is shifted in the head frame.
Effect cameraTranslation() {
  return {.name = effectName::cameraTranslation,
          .description = "the camera sits shifted in the head",
          .formula = "headFromCamera = T(x, y, z) * nominal",
          .placeKind = PlaceKind::camera,
          .unknowns = {{"x", "m", 0.005}, {"y", "m", 0.005}, {"z", "m", 0.005}},
          .correct = [](ModelState& modelState, const RobotSample&, std::size_t, std::span<const double> values) {
            modelState.mountTranslation() += Eigen::Vector3d{values[0], values[1], values[2]};
          }};
}

} // namespace naocal
