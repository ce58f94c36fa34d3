#pragma once

#include "framework/core/Clock.hpp"
#include "hardware/Joints.hpp"

#include <Eigen/Core>
#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace naocal {

/// Brightness of one coloured light, each 0 .. 1.
struct Rgb {
  float red = 0, green = 0, blue = 0;
  bool operator==(const Rgb&) const = default;
};

/// Eyes of this colour ask the person beside the robot to hold it.
constexpr Rgb holdMeColour{1, 0.75f, 0};

/// The robot's lights, each list in the robot's own order.
struct Leds {
  Rgb chest, leftFoot, rightFoot;
  std::array<Rgb, 8> leftEye{};  // from 45 degrees on, counting down
  std::array<Rgb, 8> rightEye{}; // from 0 degrees on, counting up
  std::array<float, 10> leftEar{}, rightEar{};
  std::array<float, 12> skull{};
  bool operator==(const Leds&) const = default;
};

/// What the motors shall do until the next command.
struct RobotCommand {
  RawAngles angles;             // targets; the right hip yaw-pitch is ignored, one motor drives both
  PerJoint<double> stiffness{}; // 0 .. 1 of the motor's torque; 0 or less: the motor is off
  Leds leds;
};

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

/// How the connection to the robot fares.
struct RobotStatus {
  std::uint64_t states = 0;     // received
  std::uint64_t lostStates = 0; // that the robot measured but this program did not get, as far as the driver can tell
  std::uint64_t reconnects = 0; // since the first connection
  std::string problem;          // one sentence while there is no connection; empty while there is
};

/// Joints, sensors and lights of a robot: a real one, a replayed one or a simulated one.
///
/// Threads: made and destroyed by whoever starts the motion thread, while that does not run; all other calls come from
/// the motion thread alone. The motion loop is
///
///     while (running) {
///       if (const auto state = robot.waitForState(timeout)) { robot.send(modules(*state)); }
///     }
///
/// so the robot's pace is the loop's. Nothing here throws after construction: a lost connection is absence (no state)
/// and a sentence in `status()`, and it is mended by the next calls.
class RobotInterface {
public:
  virtual ~RobotInterface() = default;

  /// Who it is, for the configuration; absent when the robot has not told within `timeout`. Called
  /// before the first `waitForState`, if at all.
  virtual std::optional<RobotIdentity> waitForIdentity(std::chrono::milliseconds timeout) = 0;

  /// Blocks until the robot has measured anew; of several that wait the newest is given, the others are counted as
  /// lost. Absent after `timeout` without a state (wall time), or at the end of a replay.
  virtual std::optional<RobotState> waitForState(std::chrono::milliseconds timeout) = 0;

  /// Answers the state that was given last. Never blocks; without a connection nothing happens.
  virtual void send(const RobotCommand& command) = 0;

  /// Between two states: 12 ms (V6), 10 ms (V5).
  virtual std::chrono::nanoseconds period() const = 0;

  /// Nothing will come any more: a replay is over. False for everything that has no end.
  virtual bool hasEnded() const { return false; }

  virtual RobotStatus status() const = 0;
};

} // namespace naocal
