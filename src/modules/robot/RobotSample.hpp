#pragma once

#include "data/Capture.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <limits>

namespace naocal {

/// What drives effects at one instant: per joint of the robot where it is a list; NaN where it was not recorded.
struct RobotSample {
  static constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

  std::size_t set = 0; // of those given: the same time in another one is another moment
  Seconds time{0};     // since the set's earliest capture
  SupportFoot supportFoot = SupportFoot::none;
  Eigen::VectorXd q;            // measured - o [rad]
  Eigen::VectorXd velocity;     // [rad/s]
  Eigen::VectorXd approach;     // -1, 0, +1
  Eigen::VectorXd temperature;  // [degC]
  Eigen::VectorXd current;      // [A]
  Eigen::VectorXd torque;       // gravity's, positive where it drives the angle up [Nm]
  Eigen::VectorXd torqueGrowth; // d(torque)/d(the motor's own angle), all else held [Nm/rad]
  Eigen::Vector2d com = Eigen::Vector2d::Constant(nothing); // centre of mass over the support foot's sole: x, y [m]
  Eigen::Vector2d imu = Eigen::Vector2d::Constant(nothing); // the torso's roll, pitch as reported [rad]
  double leftLoad = nothing;                                // the left foot's share of the weight [1]
};

/// What an effect can look at. The first four follow from the angles, hence from the offsets; the others are recorded.
enum class Driver { angle, torque, torqueGrowth, com, approach, temperature, velocity, current, time, imu };

} // namespace naocal
