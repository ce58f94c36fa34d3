#pragma once

#include "math/Sampling.hpp"
#include "robot/Robot.hpp"
#include "simulation/Truth.hpp"

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// A part of one leg that is not as drawn, as a mechanism: a gear that is a soft spring, a gear with play that lags
/// behind its last motion unless the load on it overcomes its friction, or a longer bone. What a diagnosis should find.
struct InjectedEffect {
  std::optional<std::size_t> softJoint, looseJoint, longBone; // one of them: joints, or an index into Robot::lengths
  double compliance = 0;                                      // of the soft joint [rad/Nm]
  double play = 0;                                            // of the loose one [rad]
  double friction = std::numeric_limits<double>::infinity();  // in its gap: a larger load takes up the play [Nm]
  double excess = 0;                                          // of the bone [m]

  /// The same part, as many times as bad.
  InjectedEffect scaledBy(double factor) const;
  /// How far the gears give way: the play's end that load, or else the last motion, left the joint at.
  Eigen::VectorXd lag(const Eigen::VectorXd& lastMotion, const Eigen::VectorXd& torques) const;
  /// The robot as it is: the drawing with its longer bone.
  Robot applyTo(Robot drawing) const;
  /// By the effects' names.
  TrueEffect truth(const Robot& drawing) const;
};

/// One of these in the leg that the robot stands on, of a size that a worn NAO has: a spring, play that only motion
/// takes up, or a bone.
InjectedEffect drawInjectedEffect(const Robot& drawing, SupportFoot supportFoot, RandomStream& chance);

/// The one that is asked for, of a size that a worn NAO has: "elasticity@LKneePitch" (or spring), "hysteresis@...",
/// "gearPlay@...", "linkLength@thigh". Throws InputError for any other.
InjectedEffect namedFlaw(const Robot& drawing, const std::string& label);

/// What one robot has that its drawing does not say.
struct RobotErrors {
  struct Mount {
    Eigen::Vector3d rotation = Eigen::Vector3d::Zero();    // nominal mount * Rx Ry Rz in the mount's axes [rad]
    Eigen::Vector3d translation = Eigen::Vector3d::Zero(); // in the head's frame [m]
  };
  Eigen::VectorXd jointOffsets; // per joint: the encoder shows the motor's angle + offset [rad]
  std::vector<Mount> mounts;    // per camera
  std::optional<InjectedEffect> flaw;
};

/// Errors drawn uniformly from [-range, range]: offsets per motor [rad], mounts per camera and axis [rad], [m].
RobotErrors drawErrors(const Robot& drawing, double offsetRange, double mountRange, double mountShiftRange,
                       RandomStream& chance);

/// The same by the effects' names. A camera's shift is listed where there is one.
std::vector<TrueEffect> listTrueEffects(const Robot& drawing, const RobotErrors& errors);

} // namespace naocal
