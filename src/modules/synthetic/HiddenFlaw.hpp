#pragma once

#include "model/Robot.hpp"
#include "synthetic/Randomness.hpp"
#include "synthetic/Truth.hpp"

#include <Eigen/Core>
#include <optional>
#include <string>

namespace naocal {

/// A part of one leg that is not as drawn, as a mechanism: a gear that is a soft spring, a gear with play that lags
/// behind its last motion, or a longer bone. What a diagnosis should find.
struct HiddenFlaw {
  std::optional<std::size_t> softJoint, looseJoint, longBone; // one of them: joints, or an index into Robot::lengths
  double compliance = 0;                                      // of the soft joint [rad/Nm]
  double play = 0;                                            // of the loose one [rad]
  double excess = 0;                                          // of the bone [m]

  /// The same part, as many times as bad.
  HiddenFlaw scaled(double factor) const;
  /// How far the gears give way: the play's end that the last motion left the joint at.
  Eigen::VectorXd lag(const Eigen::VectorXd& lastMotion) const;
  /// The robot as it is: the drawing with its longer bone.
  Robot built(Robot drawing) const;
  /// By the effects' names.
  TrueEffect truth(const Robot& drawing) const;
};

/// One of these in the leg that the robot stands on, of a size that a worn NAO has.
HiddenFlaw drawnFlaw(const Robot& drawing, SupportFoot supportFoot, Randomness& chance);

} // namespace naocal
