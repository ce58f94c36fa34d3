#pragma once

#include "diagnosis/views/ImageField.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace naocal {

/// Where a board's corners lie against what the model has, by all its pictures together: a sheet that is bent, was
/// printed crookedly or lies over a cable shows it here, whatever its shape. Its size does not show: no picture alone
/// tells it from the distance.
struct BoardShape {
  struct Corner {
    int id = 0;
    Eigen::Vector3d place;      // pointInBoard as the board's file has it [m]
    Eigen::Vector3d off, sigma; // really there - as modelled, in the board's axes; standard errors [m]
  };
  std::size_t board = 0;
  std::vector<Corner> corners;
  double pValue = 1; // how often noise alone would shape it as much
};

/// What a field of a board's corners, or of its sheet, says about each of them.
BoardShape boardShapeFromField(const ImageField& field, const Measurements& measurements);

/// Of each board whose pictures tell its shape; smooth, as its sheet.
std::vector<BoardShape> estimateBoardShapes(const FittedModel& fitted);

} // namespace naocal
