#pragma once

#include "data/Capture.hpp"
#include "math/Angles.hpp"

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <optional>

namespace naocal {

/// A pose as it is sent to the robot, which does not know its offsets.
struct CommandedPose {
  std::string name;
  SupportFoot supportFoot = SupportFoot::left; // not `none`: a hanging robot tells nothing about boards on the floor
  Eigen::VectorXd angles;                      // one per joint of the drawing [rad]
  Eigen::VectorXd approach = {}; // per joint: the motion that ends in the pose, -1 from above, +1 from below, 0 or
                                 // empty: as it comes
};

/// How corners are measured in the pictures.
struct CornerNoise {
  double pixel = 0.3;        // standard deviation per axis [px]
  bool heavyTails = false;   // Student's t with 4 degrees of freedom instead of a normal distribution
  double grossShare = 0;     // of corners that lie grossly wrong besides [1]
  double grossSize = 8;      // by how much [px]
  double displacedBoard = 0; // in one picture, one board lies this far off its place [m]
};

/// Cameras that see as wide as the manufacturer says (focal length 598 px at a width of 640), without distortion.
std::map<std::string, CameraIntrinsics> nominalCameras(int width, int height);

/// Four A2 boards of 7x5 squares of 80 mm on the floor: near in front, to the left, to the right and farther in front
/// of a robot that stands at the origin and looks along x.
std::vector<Board> defaultBoards();

/// Half the distance between two feet that stand side by side [m].
constexpr double halfFootDistance = 0.05;

/// How the parts of a robot behave; the same for every robot of the make.
struct RobotMechanics {
  int encoderSteps = 4096;               // per turn
  double encoderDither = radians(0.007); // sigma, per reading [rad]
  double servoDroop = 1e-3;              // motor's angle behind its target under gravity [rad/Nm]
  double servoDeadZone = radians(0.1);   // sigma of where a motor comes to rest, per approach [rad]
  double residualSpeed = 3e-4;           // sigma of the motion that is left at rest [rad/s]
  double poseScatter = 0;                // sigma of the gears' deflection behind the encoder, per pose (stiction) [rad]
  double approachScatter = 0;            // the same, drawn anew at every approach [rad]
  double imuNoise = 5e-3;                // [rad]
  double forceNoise = 0.02;              // [kg]
  double currentPerTorque = 0.25;        // [A/Nm]
  double currentNoise = 0.02;            // [A]
  double ambientTemperature = 30;        // [degC]
  double heatPerTorqueSquared = 1.5;     // warmer than ambient in the long run [K/(Nm)^2]
  double thermalTimeConstant = 600;      // [s]
};

/// What to simulate. Ranges are drawn uniformly from [-range, range].
struct SimulationPlan {
  std::vector<CommandedPose> poses;
  int samples = 3; // per pose
  RepeatKind repeatKind = RepeatKind::rest;
  bool images = false;                    // pictures will be rendered, so no corners are given
  bool surveyed = false;                  // the set states the placements of boards and stances
  double offsetRange = radians(6.5);      // per motor [rad]
  double mountRange = radians(2);         // per camera and axis [rad]
  double mountShiftRange = 0;             // per camera and axis [m]
  double boardShiftRange = 0.03;          // of boards against their `placement` [m]
  double boardTurnRange = 0.1;            // [rad]
  double stanceShiftRange = 0.04;         // of the robot against the origin, per stance [m]
  double stanceTurnRange = 0.1;           // [rad]
  std::optional<std::uint64_t> robotSeed; // of offsets and mounts, where another set's robot is wanted
  std::optional<std::uint64_t> boardSeed; // of where boards lie, where they lie as another set's
  int firstStance = 0;                    // numbers count from here
  double flawScale = 1;                   // of the hidden flaw's size: 1 is a worn NAO's
  bool hiddenFlaw = false;                // a part of the leg it stands on is not as drawn
  std::string flaw = "";                  // that part, where it is not to be drawn: "gearPlay@LKneePitch"
  RobotMechanics mechanics;
  CornerNoise corners;
  std::map<std::string, CameraIntrinsics> cameras = nominalCameras(640, 480);
  std::vector<Board> boards = defaultBoards(); // with placements: about where they lie
};

} // namespace naocal
