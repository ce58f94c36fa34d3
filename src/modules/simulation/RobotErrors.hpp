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

/// A mechanical defect of one leg, to be found by a diagnosis: a gear that acts as a soft spring, a gear with play that
/// lags behind its last motion unless the load exceeds its friction, or a longer bone.
struct InjectedEffect {
  std::optional<std::size_t> softJoint, looseJoint, longBone; // exactly one is set: joints, or an index into
                                                              // Robot::lengths
  double compliance = 0;                                      // of the soft joint [rad/Nm]
  double play = 0;                                            // of the loose joint [rad]
  double friction = std::numeric_limits<double>::infinity();  // of the loose joint: a larger load takes up the play
                                                              // [Nm]
  double excess = 0;                                          // of the bone [m]

  /// The same defect, scaled.
  InjectedEffect scaledBy(double factor) const;
  /// Deflection of the loose gear: at the end of the play given by the load, otherwise by the last motion [rad].
  Eigen::VectorXd lag(const Eigen::VectorXd& lastMotion, const Eigen::VectorXd& torques) const;
  /// The drawing with the longer bone.
  Robot applyTo(Robot drawing) const;
  /// The defect by its effect's name.
  TrueEffect truth(const Robot& drawing) const;
};

/// Draws one of these in the support leg, as large as in a worn NAO: a spring, play that only motion takes up, or a
/// bone.
InjectedEffect drawInjectedEffect(const Robot& drawing, SupportFoot supportFoot, RandomStream& chance);

/// A given defect, as large as in a worn NAO: "elasticity@LKneePitch" (or spring), "hysteresis@...", "gearPlay@...",
/// "linkLength@thigh". Throws InputError for others.
InjectedEffect namedFlaw(const Robot& drawing, const std::string& label);

/// Errors of one robot relative to its drawing.
struct RobotErrors {
  struct Mount {
    Eigen::Vector3d rotation = Eigen::Vector3d::Zero();    // nominal mount * Rx Ry Rz in the mount's axes [rad]
    Eigen::Vector3d translation = Eigen::Vector3d::Zero(); // in the head's frame [m]
  };
  Eigen::VectorXd jointOffsets; // per joint: encoder reading = motor angle + offset [rad]
  std::vector<Mount> mounts;    // per camera
  std::optional<InjectedEffect> flaw;
};

/// Draws errors uniformly from [-range, range]: offsets per motor [rad], mounts per camera and axis [rad], [m].
RobotErrors drawErrors(const Robot& drawing, double offsetRange, double mountRange, double mountShiftRange,
                       RandomStream& chance);

/// The errors by their effects' names; camera translations only if nonzero.
std::vector<TrueEffect> listTrueEffects(const Robot& drawing, const RobotErrors& errors);

} // namespace naocal
