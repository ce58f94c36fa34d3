#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace naocal {

/// How many points of a figure a diagnosis file holds: a plot some 500 pixels wide cannot show more of them apart.
constexpr std::size_t drawable = 500;
constexpr std::size_t allOfThem = std::numeric_limits<std::size_t>::max();

/// At most so many of them, spread evenly over all.
template <typename T> std::vector<T> thinned(const std::vector<T>& all, std::size_t most) {
  if (all.size() <= most) {
    return all;
  }
  std::vector<T> result;
  for (std::size_t i = 0; i < most; ++i) {
    result.push_back(all[i * all.size() / most]);
  }
  return result;
}

} // namespace naocal
