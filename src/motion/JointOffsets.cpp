#include "motion/JointOffsets.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace naocal {
void to_json(nlohmann::json& out, const JointOffsets& offsets) {
  out = {{"calibrationOffsets", offsets.values}};
}

CompensatedAngles compensate(const RawAngles& raw, const JointOffsets& offsets) {
  CompensatedAngles angles;
  for (std::size_t joint = 0; joint < jointCount; ++joint) {
    angles[joint] = raw[joint] - offsets.values[joint];
  }
  coupleHipYawPitch(angles);
  return angles;
}

JointLimits::JointLimits(const Robot& robot) : robot_{robot} {
  for (std::size_t joint = 0; joint < jointCount; ++joint) {
    drawn_[joint] = robot.jointIndex(jointNames[joint]);
  }
}

void JointLimits::clamp(PerJoint<double>& values) const {
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot_.joints.size()));
  const auto drawnAngle = [&](std::size_t drawn) -> double& { return angles[static_cast<Eigen::Index>(drawn)]; };
  for (const bool dependent : {false, true}) { // independent joints first
    for (std::size_t joint = 0; joint < jointCount; ++joint) {
      if (!drawn_[joint]) {
        values[joint] = std::clamp(values[joint], 0.0, 1.0);
      } else if (robot_.joints[*drawn_[joint]].coupled.has_value() == dependent) {
        const AngleRange range = jointLimitsAt(robot_, *drawn_[joint], angles);
        values[joint] = drawnAngle(*drawn_[joint]) = std::clamp(values[joint], range.lower, range.upper);
      }
    }
  }
}

double JointLimits::maxSpeed(std::size_t joint) const {
  return drawn_[joint] ? robot_.joints[*drawn_[joint]].maxSpeed : 0;
}

RawAngles toMotorAngles(const CompensatedAngles& desired, const JointOffsets& offsets, const JointLimits& limits) {
  const CompensatedAngles reachable = limits.clamp(desired);
  RawAngles raw;
  for (std::size_t joint = 0; joint < jointCount; ++joint) {
    raw[joint] = reachable[joint] + offsets.values[joint];
  }
  coupleHipYawPitch(raw);
  return limits.clamp(raw);
}

} // namespace naocal
