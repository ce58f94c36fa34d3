#include "measurements/JointMotion.hpp"

#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <limits>

namespace naocal {

double motionOf(std::size_t joint, const Measurements& measurements) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const ImageObservation& picture : measurements.pictures) {
    const double angle = picture.instant.q[eigenIndex(joint)];
    low = std::min(low, angle);
    high = std::max(high, angle);
  }
  return measurements.pictures.empty() ? 0 : high - low;
}

bool isStill(std::size_t joint, const Measurements& measurements) {
  return motionOf(joint, measurements) < (measurements.robot.joints[joint].isPrismatic ? stillMetres : stillRadians);
}

} // namespace naocal
