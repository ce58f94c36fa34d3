#include "captures/Capture.hpp"

namespace naocal {

std::vector<Eigen::Vector3d> innerCorners(const CharucoPattern& pattern) {
  std::vector<Eigen::Vector3d> corners;
  for (int row = 1; row < pattern.squaresY; ++row) {
    for (int column = 1; column < pattern.squaresX; ++column) {
      corners.push_back(pattern.squareLength * Eigen::Vector3d(column, -row, 0));
    }
  }
  return corners;
}

} // namespace naocal
