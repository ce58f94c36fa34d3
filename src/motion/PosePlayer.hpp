#pragma once

#include "framework/Dependency.hpp"
#include "framework/Module.hpp"
#include "framework/Parameter.hpp"
#include "framework/Production.hpp"
#include "hardware/exchange/PoseRequest.hpp"
#include "motion/Measured.hpp"
#include "motion/PoseMotion.hpp"

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
struct Ending {
  std::atomic<bool> asked{false};  // by who ends the program
  std::atomic<bool> atRest{false}; // it stands, or its motors are off or weak
};

/// Takes the robot from pose to pose: smoothly, at a share of the joints' speeds, back the way it came when it is told
/// to go home, when the chest button is pressed while it moves or holds a pose, when the program ends, or when a joint
/// gets too hot. Touched at head, hands or feet it stops where it is and holds; tilted too far its motors become weak.
///
/// It refuses to start where the robot is not near its stand, and points that joints cannot take; whether the robot
/// stands on the way is the asking one's to check (which takes longer than a cycle).
class PosePlayer final : public Module {
public:
  PosePlayer(const Robot& robot, Ending& ending) : Module{"PosePlayer"}, limits_{robot}, ending_{ending} {}
  void cycle() override;
  void parametersChanged() override;

private:
  void watch(const RobotState& state);
  void look(const PoseRequest& request);
  void go(const PoseRequest& request);
  void goHome(const std::string& reason);
  bool isReady(const std::string& who); // motors are on, or the robot is at its stand; `who` is refused otherwise
  void start(std::vector<CompensatedAngles> points);
  void leaveMotion();                               // keeps in the trail what it has passed
  void extendTrail(const CompensatedAngles& point); // back at a point of it, the loop from there is forgotten
  void stop(PlayerState::Phase phase, const std::string& reason);
  void advance();
  std::string unreachable(const PoseRequest& request) const;
  bool isNear(const CompensatedAngles& angles, const CompensatedAngles& point) const;

  Parameter<std::map<std::string, double>> stand_{*this, "stand"}; // [deg] by joint; 0 for those not named
  Parameter<double> speed_{*this, "speed"};                        // share of the joints' largest speeds
  Parameter<double> stiffness_{*this, "stiffness"};                // while playing
  Parameter<double> fallenStiffness_{*this, "fallenStiffness"};
  Parameter<double> startDistance_{*this, "startDistance"}; // of each joint from the stand [deg]
  Parameter<double> largestTilt_{*this, "largestTilt"};     // of the torso [deg]
  Parameter<double> hottest_{*this, "hottest"};             // joint [degC]
  Dependency<Measured> measured_{*this, "measured"};
  Dependency<CompensatedAngles> angles_{*this, "angles"};
  Dependency<Latest<PoseRequest>> request_{*this, "Brain.poseRequest"};
  Production<DesiredPose> desired_{*this, "desiredPose"};
  Production<PlayerState> state_{*this, "player"};
  Production<Latest<PlayerState>> forBrain_{*this, "playerForBrain"};

  JointLimits limits_;
  Ending& ending_;
  CompensatedAngles home_;
  std::vector<CompensatedAngles> trail_; // from the stand on: what a way home passes, backwards
  std::optional<PoseMotion> motion_;
  std::vector<CompensatedAngles> points_; // of that motion
  bool goingHome_ = false;
  bool wasPressed_ = false;
  TimePoint motionStart_, now_;
};

} // namespace naocal
