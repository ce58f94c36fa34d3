#include "poses/Outline.hpp"

#include <algorithm>
#include <limits>

namespace naocal {

double depthInside(const Outline& outline, const Eigen::Vector2d& point) {
  double depth = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d side = outline[(i + 1) % outline.size()] - outline[i];
    const Eigen::Vector2d inwards{-side.y(), side.x()};
    depth = std::min(depth, inwards.dot(point - outline[i]) / side.norm());
  }
  return depth;
}

bool apart(const Outline& a, const Outline& b) {
  const auto hasBeyond = [](const Outline& one, const Outline& other) {
    for (std::size_t i = 0; i < one.size(); ++i) {
      const Eigen::Vector2d side = one[(i + 1) % one.size()] - one[i];
      const Eigen::Vector2d inwards{-side.y(), side.x()};
      if (std::all_of(other.begin(), other.end(),
                      [&](const Eigen::Vector2d& corner) { return inwards.dot(corner - one[i]) < 0; })) {
        return true;
      }
    }
    return false;
  };
  return hasBeyond(a, b) || hasBeyond(b, a);
}

} // namespace naocal
