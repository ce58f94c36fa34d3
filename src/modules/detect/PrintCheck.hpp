#pragma once

#include "data/Capture.hpp"
#include "detect/CornerRefinement.hpp"
#include "detect/LensDistortion.hpp"

#include <Eigen/Core>
#include <map>

namespace naocal {

/// How well the picture agrees with what should be printed in the markers beside the corners that were found: the
/// correlation, over all these markers' inner cells, of the grey at their centres with the print (1: as printed, about
/// 0: something else is printed there). A chessboard looks the same two squares further on, its markers do not: this
/// finds a walk that began at a misread marker, and a board in the other pattern. `corners`: at least four, by id [px].
double printCorrelation(const SmoothImage& picture, const LensDistortion& lens, const CharucoPattern& pattern,
                        const std::map<int, Eigen::Vector2d>& corners);

} // namespace naocal
