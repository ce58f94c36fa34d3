#pragma once

#include "framework/core/Module.hpp"
#include "framework/core/Parameter.hpp"
#include "hardware/messages/PoseRequest.hpp"
#include "motion/PoseMotion.hpp"
#include "motion/SensorProvider.hpp"

#include <atomic>
#include <map>
#include <optional>
#include <string>

namespace naocal {

/// What the joints shall do in this cycle.
struct DesiredPose {
  CompensatedAngles angles;
  double stiffness = 0; // of all joints, 0..1
};
void to_json(nlohmann::json& out, const DesiredPose& desired);

/// How the program's end, on another thread, has the robot go to its stand first.
struct ShutdownRequest {
  std::atomic<bool> asked{false};  // by who ends the program
  std::atomic<bool> atRest{false}; // it stands, or its motors are off or weak
};

/// Takes the robot from pose to pose: smoothly, at a share of the joints' speeds, back the way it came when it is told
/// to go home, when the chest button is pressed while it moves or holds a pose, when the program ends, or when a joint
/// gets too hot. Touched at head, hands or feet it stops where it is and holds; tilted too far its motors become weak,
/// as they do where its joints were moved while nothing was heard of it.
///
/// A robot that was held on its way out is held on its way home: unless it is already, it asks for hands by its eyes,
/// and goes after some seconds, or at once when its chest button is pressed.
///
/// It refuses to start where the robot is not near its stand, and points that joints cannot take; whether the robot
/// stands on the way is the asking one's to check (which takes longer than a cycle).
class PosePlayer final : public Module {
public:
  PosePlayer(const Robot& robot, ShutdownRequest& ending) : Module{"PosePlayer"}, limits_{robot}, ending_{ending} {}
  void cycle() override;
  void onParametersChanged() override;

private:
  /// What it does; PlayerState tells less of it.
  enum class Stage {
    off,            // motors off
    fallen,         // motors weak
    atStand,        // holding the stand
    goingOut,       // towards a request's last point
    holding,        // there, or where it was stopped
    askingForHands, // holding, until somebody has taken hold of the robot or `handsUntil_`
    goingHome,      // back along the trail
  };
  void enter(Stage stage);
  bool isPlaying() const { return stage_ != Stage::off && stage_ != Stage::fallen; }
  static std::string joints(const std::map<std::string, double>& stand); // what is expected, if they are not
  void watch(const RobotState& state);
  void chestPressed();
  void afterSilence(double length); // [s]
  void look(const PoseRequest& request);
  void go(const PoseRequest& request);
  void goHome(const std::string& reason);
  void startHome();
  bool isReady(const std::string& who); // motors are on, or the robot is at its stand; `who` is refused otherwise
  void start(Stage stage, std::vector<CompensatedAngles> points);
  void leaveMotion();                               // keeps in the trail what it has passed
  void extendTrail(const CompensatedAngles& point); // back at a point of it, the loop from there is forgotten
  void stop(Stage stage, const std::string& reason);
  void advance();
  std::string unreachable(const PoseRequest& request) const;
  bool isNear(const CompensatedAngles& angles, const CompensatedAngles& point) const;

  Parameter<std::map<std::string, double>> stand_{*this, "stand", joints}; // [deg] by joint; 0 for those not named
  Parameter<double> speed_{*this, "speed", checkShare};                    // of the joints' largest speeds
  Parameter<double> stiffness_{*this, "stiffness", checkShare};            // while playing
  Parameter<double> fallenStiffness_{*this, "fallenStiffness", checkWithin<0, 1>};
  Parameter<double> startDistance_{*this, "startDistance", checkWithin<0, 30>}; // of each joint from the stand [deg]
  Parameter<double> largestTilt_{*this, "largestTilt", checkWithin<10, 90>};    // of the torso [deg]
  Parameter<double> hottest_{*this, "hottest", checkWithin<30, 100>};           // joint [degC]
  Parameter<double> handsTime_{*this, "handsTime", checkWithin<1, 60>};         // to take hold of the robot in [s]
  Dependency<SensorFrame> measured_{*this, "measured"};
  Dependency<CompensatedAngles> angles_{*this, "angles"};
  Dependency<Latest<PoseRequest>> request_{*this, "Brain.poseRequest"};
  Production<DesiredPose> desired_{*this, "desiredPose"};
  Production<PlayerState> state_{*this, "player"};
  Production<Latest<PlayerState>> forBrain_{*this, "playerForBrain"};

  JointLimits limits_;
  ShutdownRequest& ending_;
  CompensatedAngles home_;
  std::vector<CompensatedAngles> trail_; // from the stand on: what a way home passes, backwards
  Stage stage_ = Stage::off;
  std::optional<PoseMotion> motion_;      // while it goes out or home
  std::vector<CompensatedAngles> points_; // of that motion
  double motionTime_ = 0;                 // [s]
  TimePoint handsUntil_;                  // goes home then
  bool waits_ = false;                    // for a person's answer, whatever it does meanwhile
  bool wasPressed_ = false;               // the chest button, in the cycle before
  TimePoint now_;
};

} // namespace naocal
