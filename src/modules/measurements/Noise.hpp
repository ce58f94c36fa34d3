#pragma once

#include <cmath>
#include <numbers>

namespace naocal {

/// One step of the NAO's 12-bit joint encoders [rad] (4096 steps per turn).
constexpr double encoderStep = 2 * std::numbers::pi / 4096;

/// Standard deviations of what is random in a measurement.
struct Noise {
  double pixel = 0.3;                             // of a corner, per axis, anew in every picture [px]
  double encoder = encoderStep / std::sqrt(12.0); // of a reading whose steps never differ at rest, per joint [rad]
  double pose = 0;       // of a deflection that all captures of a pose share (stiction), per joint [rad]
  double stance = 0;     // of one that they share as long as the robot stands where it stands, per joint [rad]
  double reapproach = 0; // of one that they share until the pose is left and taken again, per joint [rad]
  double pixelAlike = 0; // of a corner, per axis, alike in all pictures of a rest: its place between the pixels [px]
};

/// How much a corner counts that `repeats` pictures of one rest show, against one whose error is new in every picture:
///   pixel^2 / (pixel^2 + repeats pixelAlike^2),
/// so that all of them together have the variance of their mean, pixel^2 / repeats + pixelAlike^2.
inline double cornerShare(const Noise& noise, std::size_t repeats) {
  const double alike = noise.pixelAlike / noise.pixel;
  return 1 / (1 + static_cast<double>(repeats) * alike * alike);
}

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
