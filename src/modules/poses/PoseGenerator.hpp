#pragma once

#include "poses/PoseOptions.hpp"

namespace naocal {

/// A pose in which the robot stands on one foot and sees a board.
struct PlannedPose {
  SupportFoot supportFoot = SupportFoot::left;
  Eigen::VectorXd angles;    // to be sent, one per joint of the drawing [rad]
  std::vector<Sight> sights; // by the drawn robot
};

/// The first `count` attitudes that the draw finds acceptable (PoseOptions, RandomAttitude), in the scene's terms;
/// fewer where `options.tries` do not suffice.
std::vector<Belief> stableAttitudes(const Robot& robot, const Scene& scene, const PoseOptions& options,
                                    std::size_t count);

/// Poses on one foot for boards around it (placements in the support sole's frame), arms hanging: within joint limits,
/// stable, the soles apart, a board in sight. Each is the most informative one beside those before it: greedily the
/// largest determinant of the information about offsets, cameras and boards. The same seed gives the same poses.
///
/// No part touches another; what hides a board is not looked at. Throws InputError when fewer than `count` are
/// found.
std::vector<PlannedPose> stablePoses(const Robot& robot, const std::vector<Board>& boards,
                                     const std::map<std::string, CameraIntrinsics>& cameras,
                                     const PoseOptions& options);

} // namespace naocal
