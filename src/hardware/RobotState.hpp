#pragma once

#include "framework/Clock.hpp"
#include "hardware/Joints.hpp"

#include <Eigen/Core>
#include <array>
#include <string>

namespace naocal {

/// Which robot it is: the serial numbers that choose its configuration.
struct RobotIdentity {
  std::string bodyId, headId;
  std::string bodyVersion, headVersion; // such as "6.0.0"
  bool operator==(const RobotIdentity&) const = default;
};

/// What is touched or pressed.
struct Touch {
  bool chestButton = false;
  bool headFront = false, headMiddle = false, headRear = false;
  bool leftFootLeft = false, leftFootRight = false, rightFootLeft = false, rightFootRight = false; // bumpers
  bool leftHandBack = false, leftHandLeft = false, leftHandRight = false;
  bool rightHandBack = false, rightHandLeft = false, rightHandRight = false;
  bool operator==(const Touch&) const = default;
};

struct Battery {
  double charge = 0;      // 0 empty .. 1 full
  double status = 0;      // as the robot reports it
  double current = 0;     // [A]; negative while it discharges
  double temperature = 0; // [degC]
};

/// What the robot reported in one cycle. Lists by joint in the order of `jointNames`; both hip yaw-pitches carry the
/// one motor's values.
struct RobotState {
  /// When it was measured, as near as the driver knows. A fast simulation and a replay have a time of their own: take
  /// `now` from the newest state or frame, never from the wall.
  TimePoint time;
  RawAngles angles; // measured
  PerJoint<double> stiffness{};
  PerJoint<double> current{};                              // [A]
  PerJoint<double> temperature{};                          // [degC]
  PerJoint<int> status{};                                  // as the robot reports it; 0 is healthy
  Eigen::Vector3d accelerometer = Eigen::Vector3d::Zero(); // torso's axes [m/s^2]
  Eigen::Vector3d gyroscope = Eigen::Vector3d::Zero();     // torso's axes [rad/s]
  Eigen::Vector2d torsoAngles = Eigen::Vector2d::Zero();   // roll, pitch as the inertial unit filters them [rad]
  std::array<double, 8> forces{};                          // soles: left FL, FR, RL, RR, then right [kg]
  std::array<double, 2> sonar{};                           // left, right [m]
  Touch touch;
  Battery battery;
};

} // namespace naocal
