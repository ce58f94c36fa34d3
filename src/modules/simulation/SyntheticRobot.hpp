#pragma once

#include "math/Angles.hpp"
#include "math/Sampling.hpp"
#include "simulation/RobotErrors.hpp"
#include "simulation/SimulationPlan.hpp"
#include "simulation/SyntheticBody.hpp"
#include "simulation/SyntheticCamera.hpp"

#include <array>

namespace naocal {

/// The robot at rest in a pose: what no sensor tells.
struct SettledPose {
  Eigen::VectorXd motors;     // angles on the encoders' side of the gears [rad]
  Eigen::VectorXd deflection; // of the gears: joint = motor + deflection [rad]
  Eigen::VectorXd velocity;   // residual motion [rad/s]
  Eigen::VectorXd torques;    // gravity's [Nm]
  SupportFoot supportFoot = SupportFoot::left;
};

/// A robot whose truth we know: it takes a pose, its encoders and sensors report, its cameras are somewhere.
class SyntheticRobot {
public:
  SyntheticRobot(const Robot& drawing, const RobotErrors& errors, const RobotMechanics& mechanics);

  /// Moves to a commanded pose (raw space: offsets are not known to whoever commands) and comes to rest.
  /// `lastMotion`: which way each joint turned last, -1, 0, +1.
  SettledPose moveTo(const Eigen::VectorXd& commanded, const Eigen::VectorXd& lastMotion, SupportFoot supportFoot,
                     const Eigen::VectorXd& poseDeflection, RandomStream& chance) const;
  /// How far the gears stand behind their encoders in a pose, one draw per motor [rad].
  Eigen::VectorXd drawScatter(double sigma, RandomStream& chance) const;

  /// What the joints really are `since` the robot came to rest: the one place where joint and encoder differ [rad].
  Eigen::VectorXd trueJointAngles(const SettledPose& taken, Seconds since) const;
  /// What the encoders say: the motor's angle + offset, dithered, in whole steps [rad].
  Eigen::VectorXd readEncoders(const SettledPose& taken, Seconds since, RandomStream& chance) const;

  /// soleFromTorso of the (left, on both) support foot.
  Eigen::Isometry3d soleFromTorso(const Eigen::VectorXd& joints, SupportFoot supportFoot) const;
  Eigen::Isometry3d torsoFromCamera(std::size_t camera, const Eigen::VectorXd& joints) const;

  /// Torso roll and pitch as the inertial unit reports them [rad].
  Eigen::Vector2d readImu(const Eigen::Matrix3d& worldFromTorso, RandomStream& chance) const;
  /// Left FL, FR, RL, RR, then right [kg].
  std::array<double, 8> readForces(const SettledPose& taken, RandomStream& chance) const;
  Eigen::VectorXd readCurrents(const SettledPose& taken, RandomStream& chance) const;
  /// Warms the motors for a while under gravity's torques [degC].
  void heatMotors(Eigen::VectorXd& temperatures, const Eigen::VectorXd& torques, Seconds duration) const;

  const Robot& drawing() const { return drawing_; }

  /// With one sole held still; on both, each foot's value weighted by its share of the load [Nm].
  Eigen::VectorXd gravityTorques(const Eigen::VectorXd& joints, SupportFoot supportFoot) const;

private:
  /// Joints of one motor turn together.
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
