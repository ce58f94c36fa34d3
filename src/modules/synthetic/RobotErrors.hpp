#pragma once

#include "robot/Robot.hpp"
#include "synthetic/HiddenFlaw.hpp"
#include "synthetic/Randomness.hpp"
#include "synthetic/Truth.hpp"

#include <Eigen/Core>
#include <vector>

namespace naocal {

/// What one robot has that its drawing does not say.
struct RobotErrors {
  struct Mount {
    Eigen::Vector3d rotation = Eigen::Vector3d::Zero();    // nominal mount * Rx Ry Rz in the mount's axes [rad]
    Eigen::Vector3d translation = Eigen::Vector3d::Zero(); // in the head's frame [m]
  };
  Eigen::VectorXd jointOffsets; // per joint: the encoder shows the motor's angle + offset [rad]
  std::vector<Mount> mounts;    // per camera
  std::optional<HiddenFlaw> flaw;
};

/// Errors drawn uniformly from [-range, range]: offsets per motor [rad], mounts per camera and axis [rad], [m].
RobotErrors drawnErrors(const Robot& drawing, double offsetRange, double mountRange, double mountShiftRange,
                        Randomness& chance);

/// The same by the effects' names. A camera's shift is listed where there is one.
std::vector<TrueEffect> trueEffects(const Robot& drawing, const RobotErrors& errors);

} // namespace naocal
