#include "brain/CameraMatrices.hpp"

#include "math/LinearAlgebra.hpp"
#include "robot/Kinematics.hpp"

#include <nlohmann/json.hpp>

namespace naocal {
namespace {

Eigen::Isometry3d isometry(const RigidTransform& transform) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = transform.rotation;
  result.translation() = transform.translation;
  return result;
}

/// [[angle, axis], position], lengths scaled by `metre`.
nlohmann::json kinematicMatrix(const Eigen::Isometry3d& transform, double metre) {
  const Eigen::AngleAxisd turn{transform.linear()};
  const Eigen::Vector3d position = metre * transform.translation();
  return {{turn.angle(), turn.axis().x(), turn.axis().y(), turn.axis().z()},
          {position.x(), position.y(), position.z()}};
}

} // namespace

PanelCameraPose computePanelCameraPose(const Robot& drawing, const JointSample& moment, CameraName camera,
                                       const CameraModel& cameraBelief) {
  ModelState modelState = nominalState(drawing, StateLayout{drawing.joints.size(), drawing.lengths.size(), 0});
  for (std::size_t joint = 0; joint < drawing.joints.size(); ++joint) {
    modelState.angle(joint) = moment.angles[jointIndex(drawing.joints[joint].name).value()];
  }
  modelState.mountRotation() = Eigen::Vector3d{cameraBelief.rotation.data()};
  const CameraMount& mount = drawing.cameras.at(drawing.cameraIndex(toString(camera)).value());
  const LinkPoses torsoFromLink = forwardKinematics(drawing, modelState);
  const RigidTransform& torsoFromHead = torsoFromLink[mount.link];
  Eigen::Vector3d sole = torsoFromLink[drawing.soles.front().link].translation;
  for (const Sole& other : drawing.soles) {
    const Eigen::Vector3d& place = torsoFromLink[other.link].translation;
    sole = place.z() < sole.z() ? place : sole;
  }
  RigidTransform groundFromTorso{rotationY(moment.tilt[1]) * rotationX(moment.tilt[0]), Eigen::Vector3d::Zero()};
  groundFromTorso.translation.z() = -(groundFromTorso.rotation * sole).z();
  const RigidTransform groundFromCamera = groundFromTorso * torsoFromHead * linkFromCamera(mount, modelState);
  return {isometry(torsoFromHead.inverse()), isometry(groundFromTorso.inverse()), isometry(groundFromCamera.inverse()),
          camera};
}

void CameraMatrices::cycle() {
  const auto newest = moments_->newest();
  if (!frame_->isNew || !newest) {
    return;
  }
  const CameraFrame& frame = frame_->frame;
  const auto modelState = cameras_->find(std::string{toString(frame.camera)});
  const auto moment = moments_->at(std::min(frame.time + fromSeconds(*latency_), newest->time));
  if (modelState != cameras_->end() && moment) {
    matrices_ = computePanelCameraPose(drawing_, *moment, frame.camera, modelState->second);
  }
}

void to_json(nlohmann::json& out, const PanelCameraPose& matrices) {
  constexpr double millimetres = 1000, metres = 1;
  out = {{"torso2Head", kinematicMatrix(matrices.headFromTorso, millimetres)},
         {"ground2Torso", kinematicMatrix(matrices.torsoFromGround, millimetres)},
         {"imageInfos",
          {{"ground2Camera", kinematicMatrix(matrices.cameraFromGround, metres)},
           {"identification", toString(matrices.camera)}}}};
}

} // namespace naocal
