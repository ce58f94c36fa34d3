#pragma once

#include "hardware/RobotInterface.hpp"
#include "motion/JointOffsets.hpp"

#include <string>

namespace naocal {

/// A cycle of a robot that plays poses.
struct PlayedCycle {
  const RobotState& state;
  const CompensatedAngles &wanted, &measured; // [rad]
  double step;                                // [s]
};

/// Finds faults of sensors and joints by which a playing robot could fall: a joint that does not follow its command (it
/// is blocked or weak, or its sensor is stuck or wrong by more than a calibration corrects), and an inertial unit whose
/// readings cannot be true, so that a fall would not be noticed.
class RobotFaults {
public:
  static constexpr double largestDeviation = 15;  // of a joint [deg]; play, load and offsets stay far below
  static constexpr double longestDeviation = 0.5; // [s]
  static constexpr double weakestGravity = 3, strongestGravity = 30; // accelerometer at rest: 9.81 [m/s^2]
  static constexpr double longestNonsense = 1;                       // [s]; a fall lasts shorter

  explicit RobotFaults(const JointLimits& limits) : limits_{limits} {}

  /// The fault that has lasted long enough, as a sentence of where and what; empty: none.
  std::string find(const PlayedCycle& cycle);

  /// Forgets what has lasted so far: the robot does not play.
  void reset();

private:
  JointLimits limits_;
  PerJoint<double> deviating_{}; // time [s]
  double nonsense_ = 0;          // [s]
};

} // namespace naocal
