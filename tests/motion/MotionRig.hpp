#pragma once

#include "RobotV6.hpp"
#include "ScriptedRobot.hpp"
#include "TemporaryFolder.hpp"
#include "framework/configuration/Configuration.hpp"
#include "framework/core/Database.hpp"
#include "framework/core/Module.hpp"
#include "framework/core/ModuleConfiguration.hpp"
#include "framework/core/Thread.hpp"
#include "io/Files.hpp"
#include "math/Angles.hpp"
#include "motion/JointHistory.hpp"
#include "motion/MotionModules.hpp"
#include "motion/PosePlayer.hpp"

#include <nlohmann/json.hpp>

namespace naocal {

inline constexpr std::size_t knee = *jointIndex("LKneePitch"), leftHip = *jointIndex("LHipYawPitch"),
                             rightHip = *jointIndex("RHipYawPitch"), yaw = *jointIndex("HeadYaw");

/// The shipped motion thread on a scripted robot; the brain only forwards the test's requests.
struct MotionRig {
  class Asking : public Module {
  public:
    Asking() : Module{"Asking"} {}
    void cycle() override {}
    void ask(PoseRequest request) { request_.edit().write(std::move(request)); }

  private:
    Production<Latest<PoseRequest>> request_{*this, "poseRequest"};
  };
  class Looking : public Module {
  public:
    Looking() : Module{"Looking"} {}
    void cycle() override {}
    Dependency<PlayerState> player{*this, "player"};
    Dependency<DesiredPose> desired{*this, "desiredPose"};
    Dependency<JointSampleHistory> moments{*this, "jointHistory"};
    Dependency<CompensatedAngles> angles{*this, "angles"};
    Dependency<double> stillFor{*this, "stillFor"};
    Dependency<std::string> offsetProblem{*this, "JointCalibrationProvider.problem"};
  };

  MotionRig() {
    addMotionModules(motion, robot, v6(), ending);
    database.emplace(std::vector<Thread*>{&motion, &brain});
    configureModules(motion, configuration);
    motion.cycle();
  }

  void cycles(int count) {
    for (int i = 0; i < count; ++i) {
      motion.cycle();
    }
  }
  /// Cycles until the present request is done, at most 5000 times (60 s).
  bool untilDone() {
    for (int i = 0; i < 5000 && !see.player->done; ++i) {
      motion.cycle();
    }
    return see.player->done;
  }
  /// Cycles until the robot is at its stand, at most 5000 times (60 s).
  bool untilHome() {
    for (int i = 0; i < 5000 && !see.player->atHome; ++i) {
      motion.cycle();
    }
    return see.player->atHome;
  }
  void ask(PoseRequest::Kind kind, std::vector<CompensatedAngles> points = {}, bool held = false) {
    asking.ask({++number, kind, "The pose", std::move(points), held});
    motion.cycle();
  }
  void press() {
    robot.state.touch.chestButton = true;
    cycles(3);
    robot.state.touch.chestButton = false;
    cycles(1);
  }
  /// Places the robot at its stand and lets the player hold it.
  void stand() {
    robot.state.angles.values = home().values;
    ask(PoseRequest::Kind::home);
    untilDone();
  }
  static CompensatedAngles home() {
    CompensatedAngles angles;
    for (const auto& [joint, degrees] : std::map<const char*, double>{{"LShoulderPitch", 90},
                                                                      {"LShoulderRoll", 10},
                                                                      {"LElbowRoll", -5},
                                                                      {"RShoulderPitch", 90},
                                                                      {"RShoulderRoll", -10},
                                                                      {"RElbowRoll", 5},
                                                                      {"LHipPitch", -25},
                                                                      {"LKneePitch", 50},
                                                                      {"LAnklePitch", -25},
                                                                      {"RHipPitch", -25},
                                                                      {"RKneePitch", 50},
                                                                      {"RAnklePitch", -25}}) {
      angles[*jointIndex(joint)] = radians(degrees);
    }
    return angles;
  }
  /// The stand, with these head angles [deg].
  static CompensatedAngles looking(double turn, double nod) {
    CompensatedAngles angles = home();
    angles[*jointIndex("HeadYaw")] = radians(turn);
    angles[*jointIndex("HeadPitch")] = radians(nod);
    return angles;
  }

  ScriptedRobot robot;
  ShutdownRequest ending;
  TemporaryFolder saved;
  Configuration configuration{std::filesystem::path{NAOCAL_SOURCE_DIR} / "home/configuration",
                              {"", "Ada", "Bob"},
                              [](const auto&, auto) { throw std::logic_error{"tests do not write there"}; }};
  Thread motion{"Motion", RobotPart::body}, brain{"Brain", RobotPart::head};
  Asking& asking = brain.add<Asking>();
  Looking& see = motion.add<Looking>();
  std::optional<Database> database;
  std::uint64_t number = 0;
};

} // namespace naocal
