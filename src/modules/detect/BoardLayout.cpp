#include "detect/BoardLayout.hpp"

namespace naocal {

int markerCount(const CharucoPattern& pattern) {
  return pattern.squaresX * pattern.squaresY / 2;
}

bool isBlack(const CharucoPattern& pattern, int column, int row) {
  const bool firstIsBlack = !pattern.legacyPattern || pattern.squaresY % 2 != 0;
  return ((column + row) % 2 == 0) == firstIsBlack;
}

std::optional<std::array<Eigen::Vector2d, 4>> markerOnBoard(const CharucoPattern& pattern, int id) {
  int next = pattern.firstMarkerId;
  for (int row = 0; row < pattern.squaresY; ++row) {
    for (int column = 0; column < pattern.squaresX; ++column) {
      if (!isBlack(pattern, column, row) && next++ == id) {
        const Eigen::Vector2d centre{column + 0.5, -(row + 0.5)};
        const double h = pattern.markerLength / pattern.squareLength / 2;
        return std::array<Eigen::Vector2d, 4>{centre + Eigen::Vector2d{-h, h}, centre + Eigen::Vector2d{h, h},
                                              centre + Eigen::Vector2d{h, -h}, centre + Eigen::Vector2d{-h, -h}};
      }
    }
  }
  return std::nullopt;
}

Eigen::Vector2d cornerOnBoard(const CharucoPattern& pattern, int id) {
  const int perRow = pattern.squaresX - 1;
  return {id % perRow + 1, -(id / perRow + 1)};
}

int cornerCount(const CharucoPattern& pattern) {
  return (pattern.squaresX - 1) * (pattern.squaresY - 1);
}

double symmetricReach(const CharucoPattern& pattern, int cellsPerMarker) {
  const double marker = pattern.markerLength / pattern.squareLength;
  return (1 - marker) / 2 + marker / cellsPerMarker;
}

} // namespace naocal
