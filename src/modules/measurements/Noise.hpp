#pragma once

#include <cmath>
#include <numbers>
#include <vector>

namespace naocal {

/// One step of the NAO's 12-bit joint encoders [rad] (4096 steps per turn).
constexpr double encoderStep = 2 * std::numbers::pi / 4096;

/// Standard deviations of the random measurement errors.
struct Noise {
  double pixel = 0.3;                             // corner, per axis, independent in every picture [px]
  double encoder = encoderStep / std::sqrt(12.0); // encoder reading whose steps never differ at rest, per joint [rad]
  double pose = 0;                                // joint error shared within a pose (stiction), per joint [rad]
  double stance = 0;                              // joint error shared within a stance, per joint [rad]
  double reapproach = 0;             // joint error shared until the pose is left and re-approached, per joint [rad]
  double pixelAlike = 0;             // corner, per axis, shared by all pictures of a rest: subpixel bias [px]
  std::vector<double> readings = {}; // of `Measurements::levels` [m] or [rad]; empty: as these say
};

/// Weight of a corner seen in `repeats` pictures of one rest, relative to a corner with independent errors:
///   pixel^2 / (pixel^2 + repeats pixelAlike^2),
/// so that together they have the variance of their mean, pixel^2 / repeats + pixelAlike^2.
inline double cornerShare(const Noise& noise, std::size_t repeats) {
  const double alike = noise.pixelAlike / noise.pixel;
  return 1 / (1 + static_cast<double>(repeats) * alike * alike);
}

/// Angle error of the IMU at rest, besides its tilt in the torso. Not in the data sheet; readings of a standing robot
/// drift by some tenths of a degree.
struct ImuNoise {
  static constexpr double angle = 0.005; // per axis and reading [rad]
};

/// Loss of a corner's distance from its prediction: quadratic for small distances, constant for certain outliers.
///
///   rho(s) = s for s <= a^2; its slope falls smoothly to zero at b^2; s = (distance / (pixel sigma * scale))^2
///
/// (a, b) = (3.5, 8): 0.2 % of good corners lie beyond 3.5 (two dimensions); beyond 8 a corner has no weight.
struct Loss {
  double scale = 0; // 0: quadratic everywhere
  static constexpr double inner = 3.5, outer = 8;

  /// rho(s) in units of scale^2, and its derivative, the corner's weight.
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
