#pragma once

#include "framework/core/Clock.hpp"

namespace naocal {

/// A moment so many seconds after the clock's zero.
inline TimePoint at(double value) {
  return TimePoint{} + fromSeconds(value);
}

} // namespace naocal
