#pragma once

#include "io/GreyImage.hpp"

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

namespace naocal {

/// A marker that was read in a picture.
struct Marker {
  int id = 0;
  std::array<Eigen::Vector2d, 4> corners; // [px] clockwise from the marker's own top left; good to about half a pixel
};

/// The markers of one dictionary in a picture. This file is the only one that knows which version of OpenCV's aruco
/// is in use. Throws InputError for an unknown dictionary.
std::vector<Marker> detectMarkers(const GreyPicture& picture, const std::string& dictionary);

/// A marker's cells, black border included: cell (row, column) is 1 where white.
Eigen::MatrixXi markerCells(const std::string& dictionary, int id);

} // namespace naocal
