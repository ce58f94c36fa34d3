#include "effects/Catalogue.hpp"

namespace naocal {

/// A tracker moves steadily while it measures: a tripod that sinks, cameras that warm up. 5e-6 m/s: 3 mm in ten
/// minutes. Along the axes of its place's reference: the world's where the file gives its placement, else nearly its
/// own.
Effect trackerDrift() {
  return {.name = "trackerDrift",
          .description = "the tracker moves steadily while the captures are taken",
          .formula = "worldFromTracker moves by (vx, vy, vz) * (t - t_first)",
          .placeKind = PlaceKind::tracker,
          .unknowns = {{"vx", "m/s", 5e-6}, {"vy", "m/s", 5e-6}, {"vz", "m/s", 5e-6}},
          .drivers = {Driver::time},
          .correct = [](ModelState& modelState, const RobotSample& instant, std::size_t tracker,
                        std::span<const double> values) {
            modelState.trackerPlacement(tracker).head<3>() +=
                instant.time.count() * Eigen::Vector3d::Map(values.data());
          }};
}

} // namespace naocal
