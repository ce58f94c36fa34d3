#include "synthetic/RobotErrors.hpp"

namespace naocal {

RobotErrors drawnErrors(const Robot& drawing, double offsetRange, double mountRange, double mountShiftRange,
                        Randomness& chance) {
  RobotErrors errors;
  errors.jointOffsets.resize(static_cast<Eigen::Index>(drawing.joints.size()));
  for (double& offset : errors.jointOffsets) {
    offset = chance.within(offsetRange);
  }
  for (std::size_t joint = 0; joint < drawing.joints.size(); ++joint) {
    errors.jointOffsets[static_cast<Eigen::Index>(joint)] =
        errors.jointOffsets[static_cast<Eigen::Index>(drawing.joints[joint].motor)];
  }
  for (std::size_t camera = 0; camera < drawing.cameras.size(); ++camera) {
    RobotErrors::Mount& mount = errors.mounts.emplace_back();
    for (int axis = 0; axis < 3; ++axis) {
      mount.rotation[axis] = chance.within(mountRange);
      mount.translation[axis] = chance.within(mountShiftRange);
    }
  }
  return errors;
}

std::vector<TrueEffect> trueEffects(const Robot& drawing, const RobotErrors& errors) {
  std::vector<TrueEffect> effects;
  for (std::size_t joint = 0; joint < drawing.joints.size(); ++joint) {
    if (drawing.joints[joint].motor == joint) {
      const double offset = errors.jointOffsets[static_cast<Eigen::Index>(joint)];
      effects.push_back({"jointOffset", drawing.joints[joint].name, {{"o", offset, "rad"}}});
    }
  }
  for (std::size_t camera = 0; camera < drawing.cameras.size(); ++camera) {
    const std::string& name = drawing.cameras[camera].name;
    const auto& [turn, shift] = errors.mounts[camera];
    effects.push_back(
        {"cameraRotation", name, {{"rx", turn.x(), "rad"}, {"ry", turn.y(), "rad"}, {"rz", turn.z(), "rad"}}});
    if (shift != Eigen::Vector3d::Zero()) {
      effects.push_back(
          {"cameraTranslation", name, {{"x", shift.x(), "m"}, {"y", shift.y(), "m"}, {"z", shift.z(), "m"}}});
    }
  }
  if (errors.flaw) {
    effects.push_back(errors.flaw->truth(drawing));
  }
  return effects;
}

} // namespace naocal
