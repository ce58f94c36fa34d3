#pragma once

#include "diagnosis/views/ImageField.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace naocal {

/// Deviation of a board's corners from the modelled positions, from all its pictures: shows a sheet that is bent,
/// misprinted or uneven, of any shape. Size errors do not show, since each picture fits them by distance.
struct BoardShape {
  struct Corner {
    int id = 0;
    Eigen::Vector3d place;      // pointInBoard according to the board's file [m]
    Eigen::Vector3d off, sigma; // true - modelled, in board axes; standard errors [m]
  };
  std::size_t board = 0;
  std::vector<Corner> corners;
  double pValue = 1; // probability of a shape this strong under noise alone
};

/// Corner deviations implied by a corner or sheet field.
BoardShape boardShapeFromField(const ImageField& field, const Measurements& measurements);

/// Smooth (sheet) shape of each board whose pictures determine it.
std::vector<BoardShape> estimateBoardShapes(const FittedModel& fitted);

} // namespace naocal
