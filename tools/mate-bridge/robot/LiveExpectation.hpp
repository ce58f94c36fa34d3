#pragma once

#include "robot/FloorScene.hpp"

#include <Eigen/Core>
#include <set>
#include <string>
#include <vector>

namespace naocal {

/// What nobody calibrated on a robot yet: joints by name, cameras.
struct Uncalibrated {
  std::set<std::string> joints, cameras;
};

/// Joints whose offset and cameras whose mount angles are exactly as drawn. `offsets`: the keys of
/// Motion.JointCalibrationProvider, [{"key": "headYaw", "value": 0}].
Uncalibrated findUncalibrated(const Robot& drawing, const nlohmann::json& offsets, const LiveCameras& cameras);

/// What a comparison of live predictions with live pictures rests on.
struct LiveExpectation {
  std::vector<std::string> joints; // between floor and camera, not calibrated
  bool camera = false;             // its mount is not calibrated either
  double px = 0;                   // rms of the corners that these are expected to be off by, one standard error

  /// "The right leg was never calibrated: errors up to 40 px are plausible."
  std::string sentence(const Robot& drawing, const std::string& camera) const;
};

/// How far corners seen at `pixels` may be off in a camera: each offset and mount angle that was never calibrated is
/// unknown by the sigma that its effect declares. `FloorBoardTracker` puts the boards where pictures show them, so what
/// moves the whole floor within its plane (a turned HeadYaw) shows nowhere and does not count. A robot on both feet
/// stands on the mean of what either leg says.
LiveExpectation predictLiveError(const Robot& drawing, const Eigen::VectorXd& angles, const std::string& camera,
                                 const LiveCamera& belief, const std::vector<Eigen::Vector2d>& pixels,
                                 const Uncalibrated& uncalibrated);

} // namespace naocal
