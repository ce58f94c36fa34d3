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

/// Brightness of an RGB LED, each 0 .. 1.
struct Rgb {
  float red = 0, green = 0, blue = 0;
  bool operator==(const Rgb&) const = default;
};

/// Eye colour that asks a person to hold the robot.
constexpr Rgb holdMeColour{1, 0.75f, 0};

/// The robot's LEDs, each list in the robot's order.
struct Leds {
  Rgb chest, leftFoot, rightFoot;
  std::array<Rgb, 8> leftEye{};  // from 45 degrees, descending
  std::array<Rgb, 8> rightEye{}; // from 0 degrees, ascending
  std::array<float, 10> leftEar{}, rightEar{};
  std::array<float, 12> skull{};
  bool operator==(const Leds&) const = default;
};

/// Motor and LED targets, valid until the next command.
struct RobotCommand {
  RawAngles angles;             // the right hip yaw-pitch is ignored (coupled motor)
  PerJoint<double> stiffness{}; // 0 .. 1 of the motor's torque; 0 or less: the motor is off
  Leds leds;
};

/// Serial numbers; they select the robot's configuration.
struct RobotIdentity {
  std::string bodyId, headId;
  std::string bodyVersion, headVersion; // such as "6.0.0"
  bool operator==(const RobotIdentity&) const = default;
};

/// State of touch sensors, bumpers and the chest button.
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
  double current = 0;     // [A]; negative while discharging
  double temperature = 0; // [degC]
};

/// Sensor readings of one cycle. Lists by joint are in the order of `jointNames`; both hip yaw-pitches carry the values
/// of their common motor.
struct RobotState {
  /// Time of measurement, as accurate as the driver provides. Fast simulations and replays use a time of their own:
  /// take `now` from the newest state or frame, never from the clock.
  TimePoint time;
  RawAngles angles; // measured
  PerJoint<double> stiffness{};
  PerJoint<double> current{};                              // [A]
  PerJoint<double> temperature{};                          // [degC]
  PerJoint<int> status{};                                  // the robot's status code; 0 is healthy
  Eigen::Vector3d accelerometer = Eigen::Vector3d::Zero(); // torso's axes [m/s^2]
  Eigen::Vector3d gyroscope = Eigen::Vector3d::Zero();     // torso's axes [rad/s]
  Eigen::Vector2d torsoAngles = Eigen::Vector2d::Zero();   // roll, pitch filtered by the inertial unit [rad]
  std::array<double, 8> forces{};                          // soles: left FL, FR, RL, RR, then right [kg]
  std::array<double, 2> sonar{};                           // left, right [m]
  Touch touch;
  Battery battery;
};

/// Counters and problem of the connection to the robot.
struct RobotStatus {
  std::uint64_t states = 0;     // received
  std::uint64_t lostStates = 0; // measured by the robot but not received, as far as the driver can tell
  std::uint64_t reconnects = 0; // since the first connection
  std::string problem;          // one sentence while disconnected, or about the last bad message; otherwise empty
};

/// Joints, sensors and LEDs of a real, replayed or simulated robot.
///
/// Threading: constructed and destroyed by the thread that starts the motion thread, while that does not run; all other
/// calls come from the motion thread only. The motion loop is
///
///     while (running) {
///       if (const auto state = robot.waitForState(timeout)) { robot.send(modules(*state)); }
///     }
///
/// so the robot paces the loop. Nothing throws after construction: a lost connection yields no state and a sentence in
/// `status()`; the next calls reconnect.
class RobotInterface {
public:
  virtual ~RobotInterface() = default;

  /// The robot's identity; absent after `timeout`. Call it, if needed, before the first `waitForState`.
  virtual std::optional<RobotIdentity> waitForIdentity(std::chrono::milliseconds timeout) = 0;

  /// Blocks until there is a new state; of several, returns the newest and counts the others as lost. Absent after
  /// `timeout` (wall time), or at the end of a replay.
  virtual std::optional<RobotState> waitForState(std::chrono::milliseconds timeout) = 0;

  /// Answers the state returned last. Never blocks; ignored without a connection.
  virtual void send(const RobotCommand& command) = 0;

  /// Nominal time between states: 12 ms (V6), 10 ms (V5).
  virtual std::chrono::nanoseconds period() const = 0;

  /// No more states will arrive: a replay has ended.
  virtual bool hasEnded() const { return false; }

  virtual RobotStatus status() const = 0;
};

} // namespace naocal
