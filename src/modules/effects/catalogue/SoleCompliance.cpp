#include "effects/Catalogue.hpp"

namespace naocal {

/// Sole or floor yield: the body tips over its support foot in proportion to the centre of mass in the sole frame. 0.3
/// rad/m: half a degree for 3 cm. Single support only, since the share of each foot is unknown on both.
Effect soleCompliance() {
  return {
      .name = "soleCompliance",
      .description = "the sole or the floor gives way: the body tips towards its centre of mass",
      .formula = "pitch + c * com_x, roll - c * com_y",
      .placeKind = PlaceKind::sole,
      .unknowns = {{"c", "rad/m", 0.3}},
      .drivers = {Driver::com},
      .correct = [](ModelState& modelState, const RobotSample& instant, std::size_t, std::span<const double> values) {
        if (instant.supportFoot != SupportFoot::both) {
          modelState.worldFromSupport()[3] -= values[0] * instant.com.y();
          modelState.worldFromSupport()[4] += values[0] * instant.com.x();
        }
      }};
}

} // namespace naocal
