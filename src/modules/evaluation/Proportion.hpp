#pragma once

#include <cstddef>

namespace naocal {

/// A proportion and its 95 % interval (Wilson, J. Am. Stat. Assoc. 22 (1927) 209); 0, 0 to 1 without trials.
struct Proportion {
  double share = 0, low = 0, high = 1; // [1]
};
Proportion proportion(std::size_t successes, std::size_t trials);

} // namespace naocal
