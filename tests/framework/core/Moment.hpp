#pragma once

#include "framework/core/Clock.hpp"

namespace naocal {

/// Time in seconds after the clock's zero.
inline TimePoint at(double value) {
  return TimePoint{} + fromSeconds(value);
}

} // namespace naocal
