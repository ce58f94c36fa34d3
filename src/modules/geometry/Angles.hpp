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

/// The same direction in (-pi, pi] [rad].
inline double wrapped(double angle) {
  return std::remainder(angle, 2 * std::numbers::pi);
}

} // namespace naocal
