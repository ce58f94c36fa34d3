#pragma once

#include <cmath>
#include <numbers>

namespace naocal {

/// One step of the NAO's 12-bit joint encoders [rad] (4096 steps per turn).
constexpr double encoderStep = 2 * std::numbers::pi / 4096;

/// Standard deviations of what is random in a measurement.
struct Noise {
  double pixel = 0.3;                             // of a corner, per axis [px]
  double encoder = encoderStep / std::sqrt(12.0); // of a reading, rounding included, per joint [rad]
  double pose = 0;   // of a deflection that all captures of a pose share (stiction), per joint [rad]
  double stance = 0; // of one that they share as long as the robot stands where it stands, per joint [rad]
};

/// How far an inertial unit's angles are off at rest, beside its tilt in the torso. No data sheet tells; readings of a
/// standing robot wander by some tenths of a degree.
struct ImuReading {
  static constexpr double angle = 0.005; // per axis and reading [rad]
};

/// What a corner's distance from its prediction costs: half its square near, nothing more when it is beyond doubt
/// false.
///
///   rho(s) = s for s <= a^2; falls off smoothly to a constant at b^2; s = (distance / (pixel sigma * scale))^2
///
/// (a, b) = (3.5, 8): a good corner lies beyond 3.5 in 0.2 % of cases (two dimensions), a false one counts nothing.
struct Loss {
  double scale = 0; // 0: quadratic everywhere
  static constexpr double inner = 3.5, outer = 8;

  /// rho(s) in units of scale^2, and its slope: the corner's weight.
  struct Value {
    double rho, weight;
  };
  Value operator()(double squaredDistance) const {
    if (scale == 0) {
      return {squaredDistance, 1};
    }
    constexpr double a = inner * inner, b = outer * outer;
    const double s = squaredDistance / (scale * scale);
    if (s <= a) {
      return {squaredDistance, 1};
    }
    const double left = s < b ? (b - s) / (b - a) : 0;
    return {scale * scale * (a + (b - a) / 3 * (1 - left * left * left)), left * left};
  }
};

} // namespace naocal
