#pragma once

#include "brain/ImageReader.hpp"
#include "brain/Projection.hpp"
#include "framework/core/Module.hpp"
#include "hardware/messages/JointSample.hpp"
#include "robot/Robot.hpp"

#include <Eigen/Geometry>

namespace naocal {

/// Camera pose at an image's exposure, in the format of HULKs' panel: `torso2Head` and `ground2Torso` in millimetres,
/// `ground2Camera` in metres, each as [[angle, axis], position].
struct PanelCameraPose {
  Eigen::Isometry3d headFromTorso = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d torsoFromGround = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d cameraFromGround = Eigen::Isometry3d::Identity();
  CameraName camera = CameraName::top;
};
void to_json(nlohmann::json& out, const PanelCameraPose& matrices);

/// Camera pose from joints and torso tilt at `moment` and the calibrated mount. The ground frame's origin lies on the
/// floor below the torso; its axes are the torso's without roll and pitch; the lower sole stands on the floor:
///
///   groundFromTorso = Ry(pitch) Rx(roll) T(-sole), then x = y = 0
PanelCameraPose computePanelCameraPose(const Robot& drawing, const JointSample& moment, CameraName camera,
                                       const CameraModel& modelState);

/// Publishes the camera pose of every image in the cycle of its arrival, so that the time stamps match.
class CameraMatrices final : public Module {
public:
  explicit CameraMatrices(const Robot& drawing) : Module{"CameraMatrices"}, drawing_{drawing} {}
  void cycle() override;

private:
  const Robot& drawing_;
  Dependency<NewFrame> frame_{*this, "frame"};
  Dependency<double> latency_{*this, "captureLatency"};
  Dependency<CameraModels> cameras_{*this, "cameras"};
  Dependency<JointSampleHistory> moments_{*this, "Motion.jointHistory"};
  Production<PanelCameraPose> matrices_{*this, "CameraCalibration.MatrixAndImageInfos"};
};

} // namespace naocal
