#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace naocal {

/// A place in a standard container as Eigen counts places.
inline Eigen::Index at(std::size_t i) {
  return static_cast<Eigen::Index>(i);
}

} // namespace naocal
