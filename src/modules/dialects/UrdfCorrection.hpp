#pragma once

#include "robot/Robot.hpp"

#include <Eigen/Core>
#include <map>
#include <string>
#include <string_view>

namespace naocal {

inline constexpr std::string_view urdfDialect = "urdf"; // name of the export

/// What a calibration found of a URDF's joint.
struct UrdfJointCorrection {
  double offset = 0;      // reading minus true angle [rad], [m]
  double offsetSigma = 0; // 1 sigma; 0: unknown
  // Correction of the fixed step to the joint (effect `linkGeometry`): T(translation) Rx(x) Ry(y) Rz(z).
  Eigen::Vector3d translation = Eigen::Vector3d::Zero(); // [m]
  Eigen::Vector3d rotation = Eigen::Vector3d::Zero();    // [rad]
};

/// The URDF with the origins of its joints corrected, so that it is right for the joints' readings as they are:
///
///   origin' = origin * T(translation) Rx(x) Ry(y) Rz(z) * motion(-offset),
///
/// motion(q) = the joint's own turn or slide. A joint that mimics is corrected by its ratio times the offset of the
/// joint that drives it, as well. Each corrected joint gets a comment with its offset. All else in the file stays.
/// `robot`: parsed from `text`; `name` stands for the file in messages. Throws InputError for a joint that the URDF
/// lacks.
std::string correctUrdf(const std::string& text, const std::string& name, const Robot& robot,
                        const std::map<std::string, UrdfJointCorrection>& corrections);

/// The offsets as YAML, for drivers that subtract them: `joint: {offset: .., sigma: ..}`, in rad or m. They are for the
/// URDF as it was, not for the corrected one.
std::string urdfOffsetsYaml(const Robot& robot, const std::map<std::string, UrdfJointCorrection>& corrections);

} // namespace naocal
