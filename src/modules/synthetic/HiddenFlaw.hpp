#pragma once

#include "robot/Robot.hpp"
#include "synthetic/Randomness.hpp"
#include "synthetic/Truth.hpp"

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>

namespace naocal {

/// A part of one leg that is not as drawn, as a mechanism: a gear that is a soft spring, a gear with play that lags
/// behind its last motion unless the load on it overcomes its friction, or a longer bone. What a diagnosis should find.
struct HiddenFlaw {
  std::optional<std::size_t> softJoint, looseJoint, longBone; // one of them: joints, or an index into Robot::lengths
  double compliance = 0;                                      // of the soft joint [rad/Nm]
  double play = 0;                                            // of the loose one [rad]
  double friction = std::numeric_limits<double>::infinity();  // in its gap: a larger load takes up the play [Nm]
  double excess = 0;                                          // of the bone [m]

  /// The same part, as many times as bad.
  HiddenFlaw scaled(double factor) const;
  /// How far the gears give way: the play's end that load, or else the last motion, left the joint at.
  Eigen::VectorXd lag(const Eigen::VectorXd& lastMotion, const Eigen::VectorXd& torques) const;
  /// The robot as it is: the drawing with its longer bone.
  Robot built(Robot drawing) const;
  /// By the effects' names.
  TrueEffect truth(const Robot& drawing) const;
};

/// One of these in the leg that the robot stands on, of a size that a worn NAO has: a spring, play that only motion
/// takes up, or a bone.
HiddenFlaw drawnFlaw(const Robot& drawing, SupportFoot supportFoot, Randomness& chance);

/// The one that is asked for, of a size that a worn NAO has: "elasticity@LKneePitch" (or spring), "hysteresis@...",
/// "gearPlay@...", "linkLength@thigh". Throws InputError for any other.
HiddenFlaw namedFlaw(const Robot& drawing, const std::string& label);

} // namespace naocal
