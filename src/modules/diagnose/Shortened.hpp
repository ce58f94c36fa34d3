#pragma once

#include <cassert>
#include <cmath>

namespace naocal {

/// Finer than any figure shows, and a file that stays small.
inline double shortened(double value, int digits = 5) {
  assert(std::isfinite(value));
  if (value == 0) {
    return 0;
  }
  const double scale = std::pow(10.0, digits - 1 - std::floor(std::log10(std::abs(value))));
  return std::round(value * scale) / scale;
}

} // namespace naocal
