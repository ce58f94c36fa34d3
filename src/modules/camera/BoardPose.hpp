#pragma once

#include "camera/ObservationChain.hpp"
#include "math/RigidTransform.hpp"

#include <Eigen/Core>
#include <optional>

namespace naocal {

/// opticalFromBoard of a flat board from its corners alone, by the homography between board and undistorted picture
/// (direct linear transformation; Hartley and Zisserman, Multiple View Geometry, 2nd ed., algorithm 4.2 and section
/// 8.1.1). An initial value, not an estimate. Absent for fewer than four corners, for a board behind the camera,
/// and where the corners leave the pose open: on a line, or all but one.
std::optional<RigidTransform> estimateBoardPose(const CornerBlocks& corners, const Eigen::Matrix<double, 9, 1>& lens);

} // namespace naocal
