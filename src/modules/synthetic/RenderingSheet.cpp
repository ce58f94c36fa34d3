#include "synthetic/RenderingSheet.hpp"

#include "detect/Markers.hpp"

namespace naocal {

RenderingSheet::RenderingSheet(const CharucoPattern& pattern, double margin)
    : squaresX_{pattern.squaresX}, squaresY_{pattern.squaresY}, squareLength_{float(pattern.squareLength)},
      width_{float(pattern.squaresX * pattern.squareLength)}, height_{float(pattern.squaresY * pattern.squareLength)},
      margin_{float(margin)}, gap_{float((1 - pattern.markerLength / pattern.squareLength) / 2)} {
  const bool firstIsWhite = pattern.legacyPattern && pattern.squaresY % 2 == 0;
  int count = 0;
  for (int row = 0; row < pattern.squaresY; ++row) {
    for (int column = 0; column < pattern.squaresX; ++column) {
      const bool white = ((row + column) % 2 != 0) != firstIsWhite;
      markers_.push_back(white ? count++ : -1);
    }
  }
  for (int marker = 0; marker < count; ++marker) {
    const Eigen::MatrixXi cells = markerCells(pattern.dictionary, pattern.firstMarkerId + marker);
    cellCount_ = std::size_t(cells.rows());
    for (Eigen::Index row = 0; row < cells.rows(); ++row) {
      for (Eigen::Index column = 0; column < cells.cols(); ++column) {
        cells_.push_back(float(cells(row, column)));
      }
    }
  }
  cellsPerSquare_ = float(double(cellCount_) * pattern.squareLength / pattern.markerLength);
}

} // namespace naocal
