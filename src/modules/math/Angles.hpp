#pragma once

#include <cmath>
#include <numbers>

namespace naocal {

constexpr double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}
constexpr double degrees(double radians) {
  return radians * 180 / std::numbers::pi;
}

/// Sine and cosine; skips the computation for angle 0, the most frequent one of mounts and placements.
struct SineCosine {
  explicit SineCosine(double angle) {
    if (angle != 0) {
      sine = std::sin(angle);
      cosine = std::cos(angle);
    }
  }
  double sine = 0, cosine = 1;
};

/// The equivalent angle in [-pi, pi] [rad].
inline double wrapAngle(double angle) {
  return std::remainder(angle, 2 * std::numbers::pi);
}

} // namespace naocal
