#pragma once

#include "residuals/Residuals.hpp"

#include <vector>

namespace naocal {

/// rms distance of corners that noise alone leaves [px]: of corners and, through the slopes J, of the joints' readings
/// and levels, sqrt(2 sum (pixel^2 n + tr(J S J^T)) / sum n) over poses of n numbers.
double noiseFloorPx(const std::vector<PoseRows>& poses, const Noise& noise);

} // namespace naocal
