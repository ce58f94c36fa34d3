#include "effects/Catalogue.hpp"

namespace naocal {

/// A tracker's readings are too long or too short. 0.2 %: cameras whose calibration aged.
Effect trackerScale() {
  return {.name = "trackerScale",
          .description = "the tracker's metre is not a metre",
          .formula = "reading = (1 + s) * point in the tracker's frame",
          .placeKind = PlaceKind::tracker,
          .unknowns = {{"s", "1", 0.002}},
          .correct = [](ModelState& modelState, const RobotSample&, std::size_t tracker,
                        std::span<const double> values) { modelState.trackerScale(tracker) += values[0]; }};
}

} // namespace naocal
