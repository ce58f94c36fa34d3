#pragma once

#include <cstddef>

namespace naocal {

/// When something happened in one of the sets, since its first capture.
struct Moment {
  std::size_t set = 0;
  double time = 0;             // likeliest [s]
  double since = 0, until = 0; // surely between these times [s]
};

} // namespace naocal
