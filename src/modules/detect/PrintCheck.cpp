#include "detect/PrintCheck.hpp"

#include "data/Board.hpp"
#include "detect/CornerRefinement.hpp"
#include "detect/MarkerDetector.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace naocal {
namespace {

constexpr double beside = 0.8; // [squares] from a corner to a marker's centre: just over half a square's diagonal

/// Grey at the centres of a marker's inner cells, row by row; empty if it leaves the picture.
Eigen::ArrayXd seenCells(const SmoothImage& picture, const LensDistortion& lens, const Eigen::Matrix3d& homography,
                         const std::array<Eigen::Vector2d, 4>& marker, Eigen::Index cells) {
  Eigen::ArrayXd seen((cells - 2) * (cells - 2));
  for (Eigen::Index row = 1; row + 1 < cells; ++row) {
    for (Eigen::Index column = 1; column + 1 < cells; ++column) {
      const Eigen::Vector2d onBoard = marker[0] + (double(column) + 0.5) / double(cells) * (marker[1] - marker[0]) +
                                      (double(row) + 0.5) / double(cells) * (marker[3] - marker[0]);
      const Eigen::Vector2d place = lens.distort((homography * onBoard.homogeneous()).hnormalized());
      if (!picture.contains(place)) {
        return {};
      }
      seen((row - 1) * (cells - 2) + column - 1) = picture.sample(place).grey;
    }
  }
  return seen;
}

} // namespace

double printCorrelation(const SmoothImage& picture, const LensDistortion& lens, const CharucoPattern& pattern,
                        const std::map<int, Eigen::Vector2d>& corners) {
  std::vector<PointMatch> observations;
  for (const auto& [id, place] : corners) {
    observations.push_back({cornerOnBoard(pattern, id), lens.undistort(place), 1});
  }
  double together = 0, seenSquares = 0, printedSquares = 0;
  for (int id = pattern.firstMarkerId; id < pattern.firstMarkerId + markerCount(pattern); ++id) {
    const auto marker = *markerOnBoard(pattern, id);
    const Eigen::Vector2d centre = (marker[0] + marker[2]) / 2;
    const bool near = std::any_of(observations.begin(), observations.end(),
                                  [&](const PointMatch& corner) { return (corner.onBoard - centre).norm() <= beside; });
    if (!near) {
      continue;
    }
    const Eigen::MatrixXi cells = markerCells(pattern.dictionary, id);
    Eigen::ArrayXd seen = seenCells(picture, lens, *fitLocalHomography(observations, centre), marker, cells.rows());
    if (seen.size() == 0) {
      continue;
    }
    const Eigen::Index inner = cells.rows() - 2;
    Eigen::ArrayXd printed = cells.block(1, 1, inner, inner).cast<double>().reshaped<Eigen::RowMajor>();
    seen -= seen.mean();
    printed -= printed.mean();
    together += (seen * printed).sum();
    seenSquares += seen.square().sum();
    printedSquares += printed.square().sum();
  }
  return seenSquares > 0 ? together / std::sqrt(seenSquares * printedSquares) : 0;
}

} // namespace naocal
