#pragma once

#include "framework/core/Module.hpp"
#include "framework/core/Parameter.hpp"
#include "hardware/messages/PoseRequest.hpp"
#include "motion/PoseMotion.hpp"
#include "motion/RobotFaults.hpp"
#include "motion/SensorProvider.hpp"

#include <atomic>
#include <map>
#include <optional>
#include <string>

namespace naocal {

/// Joint targets for this cycle.
struct DesiredPose {
  CompensatedAngles angles;
  double stiffness = 0; // of all joints, 0..1
};
void to_json(nlohmann::json& out, const DesiredPose& desired);

/// Handshake between the program's shutdown, on another thread, and the motion thread, which first moves the robot to
/// its stand.
struct ShutdownRequest {
  std::atomic<bool> asked{false};  // set by the shutting-down thread
  std::atomic<bool> atRest{false}; // at the stand, or motors off or weak
};

/// Moves the robot from pose to pose, smoothly and at a fraction of the joints' maximum speeds.
///
/// It returns along the path it came: on request, when the chest button is pressed during a motion or in a pose, when
/// the program ends, when a joint overheats, or at a fault of a joint or the inertial unit (RobotFaults). A touch of
/// head, hands or feet stops a motion and holds the pose. The motors become weak when the torso tilts too far, and when
/// the joints have moved during a gap in the robot's states.
///
/// A robot that was held on its way out must be held on its way home: unless it already is, the eyes turn yellow and
/// the way home starts after `handsTime`, or at once when the chest button is pressed.
///
/// Requests are refused if the robot is not near its stand or a point exceeds a joint limit. The caller guarantees
/// balance along each segment, since checking it takes longer than a cycle.
class PosePlayer final : public Module {
public:
  PosePlayer(const Robot& robot, ShutdownRequest& ending) : Module{"PosePlayer"}, limits_{robot}, ending_{ending} {}
  void cycle() override;
  void onParametersChanged() override;

private:
  /// Internal stage; PlayerState exposes a coarser phase.
  enum class Stage {
    off,            // motors off
    fallen,         // motors weak
    atStand,        // holding the stand
    goingOut,       // moving to a request's last point
    holding,        // at the last point, or where it was stopped
    askingForHands, // holding until the chest button is pressed or `handsUntil_` has passed
    goingHome,      // moving back along the trail
  };
  void enter(Stage stage);
  bool isPlaying() const { return stage_ != Stage::off && stage_ != Stage::fallen; }
  static std::string joints(const std::map<std::string, double>& stand); // validator: the expectation if a joint name
                                                                         // or angle is wrong
  void watch(const RobotState& state);
  void chestPressed();
  void afterSilence(double length); // [s]
  void look(const PoseRequest& request);
  void go(const PoseRequest& request);
  void goHome(const std::string& reason);
  void startHome();
  bool isReady(const std::string& who); // motors on, or robot near its stand; otherwise refuses the request of `who`
  void start(Stage stage, std::vector<CompensatedAngles> points);
  void leaveMotion();                               // ends the motion; appends its passed points to the trail
  void extendTrail(const CompensatedAngles& point); // removes the loop if the point is already in the trail
  void stop(Stage stage, const std::string& reason);
  void advance();
  std::string unreachable(const PoseRequest& request) const;
  bool isNear(const CompensatedAngles& angles, const CompensatedAngles& point) const;

  Parameter<std::map<std::string, double>> stand_{*this, "stand", joints}; // [deg] by joint; others are 0
  Parameter<double> speed_{*this, "speed", checkShare};                    // fraction of the joints' maximum speeds
  Parameter<double> stiffness_{*this, "stiffness", checkShare};            // while playing
  Parameter<double> fallenStiffness_{*this, "fallenStiffness", checkWithin<0, 1>};
  Parameter<double> startDistance_{*this, "startDistance", checkWithin<0, 30>}; // of each joint from the stand [deg]
  Parameter<double> largestTilt_{*this, "largestTilt", checkWithin<10, 90>}; // of the torso; beyond: motors weak [deg]
  Parameter<double> hottest_{*this, "hottest", checkWithin<30, 100>};   // joint; above it the robot goes home [degC]
  Parameter<double> handsTime_{*this, "handsTime", checkWithin<1, 60>}; // for a person to take hold of the robot [s]
  Dependency<SensorFrame> measured_{*this, "measured"};
  Dependency<CompensatedAngles> angles_{*this, "angles"};
  Dependency<Latest<PoseRequest>> request_{*this, "Brain.poseRequest"};
  Production<DesiredPose> desired_{*this, "desiredPose"};
  Production<PlayerState> state_{*this, "player"};
  Production<Latest<PlayerState>> forBrain_{*this, "playerForBrain"};

  JointLimits limits_;
  RobotFaults faults_{limits_};
  ShutdownRequest& ending_;
  CompensatedAngles home_;
  std::vector<CompensatedAngles> trail_; // points from the stand on; the way home passes them in reverse
  Stage stage_ = Stage::off;
  std::optional<PoseMotion> motion_;      // while moving
  std::vector<CompensatedAngles> points_; // of `motion_`
  double motionTime_ = 0;                 // [s]
  TimePoint handsUntil_;                  // the way home starts then
  bool waits_ = false;                    // for an operator's answer: the chest button then counts as the answer
  bool wasPressed_ = false;               // chest button in the previous cycle
  TimePoint now_;
};

} // namespace naocal
