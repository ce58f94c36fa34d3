#pragma once

#include "robot/FloorScene.hpp"

#include <Eigen/Core>
#include <set>
#include <string>
#include <vector>

namespace naocal {

/// Uncalibrated joints and cameras, by name.
struct Uncalibrated {
  std::set<std::string> joints, cameras;
};

/// Joints and cameras whose offset or mount rotation is exactly zero. `offsets`: the keys of
/// Motion.JointCalibrationProvider, [{"key": "headYaw", "value": 0}].
Uncalibrated findUncalibrated(const Robot& drawing, const nlohmann::json& offsets, const LiveCameras& cameras);

/// Expected error of live predictions.
struct LiveExpectation {
  std::vector<std::string> joints; // uncalibrated joints between floor and camera
  bool camera = false;             // its mount is uncalibrated
  double px = 0;                   // expected rms of corner errors, 1 sigma [px]

  /// "The right leg was never calibrated: errors up to 40 px are plausible."
  std::string sentence(const Robot& drawing, const std::string& camera) const;
};

/// Predicts the error of corners at `pixels`. Each uncalibrated offset and mount angle has the sigma that its effect
/// declares. `FloorBoardTracker` places boards where images show them, so motions of the whole floor within its plane
/// (a rotation of HeadYaw) are invisible and excluded. For a robot on both feet the two legs are averaged.
LiveExpectation predictLiveError(const Robot& drawing, const Eigen::VectorXd& angles, const std::string& camera,
                                 const LiveCamera& modelState, const std::vector<Eigen::Vector2d>& pixels,
                                 const Uncalibrated& uncalibrated);

} // namespace naocal
