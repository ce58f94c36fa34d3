#pragma once

#include "hardware/RobotInterface.hpp"
#include "hardware/simulated/RestingPlane.hpp"
#include "hardware/simulated/Servo.hpp"
#include "hardware/simulated/SimulatedPlan.hpp"
#include "simulation/SyntheticRobot.hpp"

#include <Eigen/Geometry>

namespace naocal {

/// Mechanics of a simulated robot on a flat floor: servos, gravity, support foot, falling. Quasi-static: no
/// oscillations, no impacts. A simulated person holds the robot while its eyes are `holdMeColour`.
class SimulatedBody {
public:
  SimulatedBody(const Robot& drawing, const SimulatedPlan& plan, const SimulatedErrors& errors);

  void command(const RobotCommand& command);
  void advance(Seconds step);

  /// Simulates all sensors except time, touch and battery.
  void measure(RobotState& state);

  /// True angles of all joints in the drawing [rad].
  Eigen::VectorXd trueAngles() const;
  const Eigen::Isometry3d& worldFromTorso() const { return worldFromTorso_; }
  Eigen::Isometry3d worldFromCamera(std::size_t camera, const Eigen::VectorXd& joints,
                                    const Eigen::Isometry3d& worldFromTorso) const;
  SupportFoot supportFoot() const { return support_; }
  bool hasFallen() const { return fall_.has_value(); }

private:
  struct SolePlacement { // pose of a sole on the floor
    double x = 0, y = 0, yaw = 0;
  };
  struct Contact {
    std::vector<Eigen::Vector3d> points; // in the torso's frame [m]
    Eigen::Vector3d centreOfMass;
  };
  Contact contactOf(const std::vector<Eigen::Isometry3d>& torsoFromLink) const;
  void putDown();
  RestingPlane held(const std::vector<Eigen::Vector3d>& points, const Eigen::Isometry3d* torsoFromSole) const;
  void turnMotors(Seconds step);
  void settle(Seconds step);
  void fall(Seconds step);
  void anchor(SupportFoot foot, const Eigen::Isometry3d& torsoFromSole);
  std::size_t soleLink(SupportFoot foot) const;
  SettledPose taken() const;

  Robot drawing_;
  SimulatedPlan plan_;
  SyntheticRobot robot_;
  SyntheticBody body_;
  Eigen::VectorXd offsets_;
  RandomStream motion_, sensors_;
  std::vector<std::size_t> jointOfHardware_; // index in `jointNames`, per joint of the drawing
  std::vector<Servo> servos_;                // per joint of the drawing; a coupled joint uses its motor's servo
  PerJoint<double> stiffness_{}, hands_{};
  Eigen::VectorXd torques_, temperatures_, torquesAt_; // torquesAt_: angles for which torques_ were computed
  bool held_ = false;
  SupportFoot support_ = SupportFoot::both, anchored_ = SupportFoot::left;
  SolePlacement stand_;
  Eigen::Isometry3d worldFromTorso_ = Eigen::Isometry3d::Identity();
  Eigen::Vector3d turnRate_ = Eigen::Vector3d::Zero(); // of the torso, in its axes [rad/s]
  struct Fall {
    Eigen::Vector3d axis; // in the world
    double angle;         // current [rad]
  };
  std::optional<Fall> fall_;
};

} // namespace naocal
