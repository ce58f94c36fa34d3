#pragma once

#include "data/Capture.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <optional>

namespace naocal {

/// Drivers of effects at one instant; vectors have one entry per joint of the robot, NaN where not recorded.
struct RobotSample {
  static constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

  std::size_t set = 0; // index of the set; times of different sets are not comparable
  Seconds time{0};     // since the set's first capture
  SupportFoot supportFoot = SupportFoot::none;
  std::optional<std::size_t> supportLink;                 // of a robot without `supportFoot`: base or sole
  Eigen::Vector3d upInSupport = Eigen::Vector3d::UnitZ(); // against gravity, in that link's frame
  Eigen::VectorXd q;                                      // measured - o [rad]
  Eigen::VectorXd velocity;                               // [rad/s]
  Eigen::VectorXd approach;                               // -1, 0, +1
  Eigen::VectorXd temperature;                            // [degC]
  Eigen::VectorXd current;                                // [A]
  Eigen::VectorXd torque;                                 // gravity's, positive where it drives the angle up [Nm]
  Eigen::Matrix2Xd lateralTorque;                         // gravity's about the normals of each joint's axis [Nm]
  Eigen::VectorXd torqueGrowth; // d(torque)/d(angle of its own motor), other angles fixed [Nm/rad]
  Eigen::Vector2d com = Eigen::Vector2d::Constant(nothing); // centre of mass in the support sole frame: x, y [m]
  Eigen::Vector2d imu = Eigen::Vector2d::Constant(nothing); // reported torso roll, pitch [rad]
  double leftLoad = nothing;                                // share of the weight on the left foot, 0..1
};

/// Possible inputs of an effect. The first six follow from the angles, hence from the offsets; the others are recorded.
enum class Driver {
  angle,
  torque,
  torqueGrowth,
  lateral1,
  lateral2,
  com,
  approach,
  temperature,
  velocity,
  current,
  time,
  imu
};

inline bool followsFromAngles(Driver driver) {
  return driver < Driver::approach;
}

/// Whether it goes on changing while the robot rests: what depends on it explains, but does not predict.
inline bool isTransient(Driver driver) {
  return driver == Driver::time || driver == Driver::temperature;
}

} // namespace naocal
