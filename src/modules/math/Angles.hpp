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

/// Sine and cosine; no work where the angle is exactly zero, as most angles of mounts and placements are.
struct SineCosine {
  explicit SineCosine(double angle) {
    if (angle != 0) {
      sine = std::sin(angle);
      cosine = std::cos(angle);
    }
  }
  double sine = 0, cosine = 1;
};

/// The same direction in (-pi, pi] [rad].
inline double wrapAngle(double angle) {
  return std::remainder(angle, 2 * std::numbers::pi);
}

} // namespace naocal
