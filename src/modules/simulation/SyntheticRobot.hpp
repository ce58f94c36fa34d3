#pragma once

#include "math/Angles.hpp"
#include "math/Sampling.hpp"
#include "simulation/RobotErrors.hpp"
#include "simulation/SimulationPlan.hpp"
#include "simulation/SyntheticBody.hpp"
#include "simulation/SyntheticCamera.hpp"

#include <array>

namespace naocal {

/// True state of the robot at rest in a pose.
struct SettledPose {
  Eigen::VectorXd motors;     // motor angles, before the gears [rad]
  Eigen::VectorXd deflection; // of the gears: joint = motor + deflection [rad]
  Eigen::VectorXd velocity;   // residual motion [rad/s]
  Eigen::VectorXd torques;    // by gravity [Nm]
  SupportFoot supportFoot = SupportFoot::left;
};

/// A simulated robot with known errors: moves to poses, reads sensors, places cameras.
class SyntheticRobot {
public:
  SyntheticRobot(const Robot& drawing, const RobotErrors& errors, const RobotMechanics& mechanics);

  /// Moves to a commanded pose (raw angles: the commander does not know the offsets) and comes to rest. `lastMotion`:
  /// direction of each joint's last motion, -1, 0, +1. `poseDeflection`: gear deflection in this pose [rad].
  SettledPose moveTo(const Eigen::VectorXd& commanded, const Eigen::VectorXd& lastMotion, SupportFoot supportFoot,
                     const Eigen::VectorXd& poseDeflection, RandomStream& chance) const;
  /// Draws gear deflections behind the encoders, one value per motor [rad].
  Eigen::VectorXd drawScatter(double sigma, RandomStream& chance) const;

  /// True joint angles `since` the robot came to rest; includes gear deflections, which encoders do not see [rad].
  Eigen::VectorXd trueJointAngles(const SettledPose& taken, Seconds since) const;
  /// Encoder readings: motor angle + offset + dither, rounded to steps [rad].
  Eigen::VectorXd readEncoders(const SettledPose& taken, Seconds since, RandomStream& chance) const;

  /// soleFromTorso of the support foot (on both feet, the left one).
  Eigen::Isometry3d soleFromTorso(const Eigen::VectorXd& joints, SupportFoot supportFoot) const;
  Eigen::Isometry3d torsoFromCamera(std::size_t camera, const Eigen::VectorXd& joints) const;

  /// Torso roll and pitch, with noise of the inertial unit [rad].
  Eigen::Vector2d readImu(const Eigen::Matrix3d& worldFromTorso, RandomStream& chance) const;
  /// Readings left FL, FR, RL, RR, then right [kg].
  std::array<double, 8> readForces(const SettledPose& taken, RandomStream& chance) const;
  Eigen::VectorXd readCurrents(const SettledPose& taken, RandomStream& chance) const;
  /// Updates motor temperatures [degC] after `duration` under the given torques.
  void heatMotors(Eigen::VectorXd& temperatures, const Eigen::VectorXd& torques, Seconds duration) const;

  const Robot& drawing() const { return drawing_; }

  /// Gravity torques with the support sole fixed; on both feet, weighted by each foot's share of the load [Nm].
  Eigen::VectorXd gravityTorques(const Eigen::VectorXd& joints, SupportFoot supportFoot) const;

private:
  /// Sets joints of one motor to the same angle.
  void followMotors(Eigen::VectorXd& angles) const;
  void yield(SettledPose& taken, const Eigen::VectorXd& lastMotion) const;
  std::array<double, 8> forces(const Eigen::VectorXd& joints, SupportFoot supportFoot) const;
  Eigen::Vector3d rightSoleOffFloor(const Eigen::VectorXd& joints) const;
  void settleOnBothSoles(SettledPose& taken) const;
  std::size_t soleLink(SupportFoot supportFoot) const;

  Robot drawing_;
  RobotErrors errors_;
  RobotMechanics mechanics_;
  SyntheticBody body_;
};

} // namespace naocal
