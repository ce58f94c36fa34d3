#pragma once

#include "captures/Capture.hpp"

#include <algorithm>
#include <vector>

namespace naocal {

/// The printed sheet of a ChArUco board as a function of the place on it: 0 ink, 1 paper, absent beyond the paper.
///
/// The first square of the first row is black; in the legacy pattern with an even number of rows it is white.
/// White squares hold the markers, numbered along rows from the top left, upright and centred.
class RenderingSheet {
public:
  RenderingSheet(const CharucoPattern& pattern, double margin);

  /// `x` to the right, `down` from the pattern's top left corner [m]; negative: beyond the sheet.
  float brightness(float x, float down) const {
    if (x < -margin_ || down < -margin_ || x >= width_ + margin_ || down >= height_ + margin_) {
      return -1;
    }
    if (x < 0 || down < 0 || x >= width_ || down >= height_) {
      return 1;
    }
    const float column = x / squareLength_, row = down / squareLength_;
    const int squareX = std::min(int(column), squaresX_ - 1), squareY = std::min(int(row), squaresY_ - 1); // rounding
    const int marker = markers_[std::size_t(squareY * squaresX_ + squareX)];
    if (marker < 0) {
      return 0;
    }
    const float cellX = (column - float(squareX) - gap_) * cellsPerSquare_;
    const float cellY = (row - float(squareY) - gap_) * cellsPerSquare_;
    if (cellX < 0 || cellY < 0 || cellX >= float(cellCount_) || cellY >= float(cellCount_)) {
      return 1;
    }
    return cells_[(std::size_t(marker) * cellCount_ + std::size_t(cellY)) * cellCount_ + std::size_t(cellX)];
  }

private:
  int squaresX_, squaresY_;
  float squareLength_, width_, height_, margin_; // [m]
  std::size_t cellCount_ = 0;                    // along a marker's side, black border included
  float gap_;                                    // between a square's edge and its marker, in squares
  float cellsPerSquare_ = 0;
  std::vector<int> markers_; // by square: which marker it holds, -1 in a black square
  std::vector<float> cells_; // by marker, row, column
};

} // namespace naocal
