#include "effects/Catalogue.hpp"

namespace naocal {

/// The IMU is tilted in the torso; HULKs stores the correction as `torsoCalibration`. 0.03 rad: 2 degrees. Pictures do
/// not depend on it: each recorded `imu` reading is a measurement of the torso over the sole.
Effect imuTilt() {
  return {.name = "imuTilt",
          .description = "the inertial unit sits tilted in the torso",
          .formula = "torso attitude = reading * Ry(pitch) * Rx(roll)",
          .placeKind = PlaceKind::all,
          .unknowns = {{"roll", "rad", 0.03}, {"pitch", "rad", 0.03}},
          .drivers = {Driver::imu},
          .correct = [](ModelState& modelState, const RobotSample&, std::size_t, std::span<const double> values) {
            modelState.imuTilt() += Eigen::Vector2d{values[0], values[1]};
          }};
}

} // namespace naocal
