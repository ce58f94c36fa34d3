#pragma once

#include "data/Capture.hpp"
#include "detect/CornerRefinement.hpp"
#include "detect/LensDistortion.hpp"

#include <Eigen/Core>
#include <map>

namespace naocal {

/// Correlation between the picture and the expected print of the markers beside the detected corners: grey at the
/// centres of all their inner cells against the pattern (1: as printed, about 0: another print). Detects region growing
/// from a misread marker and the other layout: the chessboard repeats every two squares, the markers do not. `corners`:
/// at least four, by id [px].
double printCorrelation(const SmoothImage& picture, const LensDistortion& lens, const CharucoPattern& pattern,
                        const std::map<int, Eigen::Vector2d>& corners);

} // namespace naocal
