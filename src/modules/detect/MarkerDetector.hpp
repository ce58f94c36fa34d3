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
  std::array<Eigen::Vector2d, 4> corners; // [px] clockwise from the marker's own top left; accurate to about 0.5 px
};

/// Detects the markers of one dictionary. Only this file depends on the version of OpenCV's aruco module. Throws
/// InputError for an unknown dictionary.
std::vector<Marker> detectMarkers(const GreyPicture& picture, const std::string& dictionary);

/// Cells of a marker, black border included: 1 for white.
Eigen::MatrixXi markerCells(const std::string& dictionary, int id);

} // namespace naocal
