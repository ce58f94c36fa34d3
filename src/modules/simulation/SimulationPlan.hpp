#pragma once

#include "data/Capture.hpp"
#include "math/Angles.hpp"

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <optional>

namespace naocal {

/// A pose as commanded, without offsets.
struct CommandedPose {
  std::string name;
  SupportFoot supportFoot = SupportFoot::left; // not `none`: a hanging robot has no fixed pose relative to boards on
                                               // the floor
  Eigen::VectorXd angles;                      // one per joint of the drawing [rad]
  Eigen::VectorXd approach = {}; // per joint: direction of the final motion, -1 from above, +1 from below, 0 or empty:
                                 // direction of the commanded change
};

/// Simulated measurement noise of corners.
struct CornerNoise {
  double pixel = 0.3;        // standard deviation per axis [px]
  bool heavyTails = false;   // Student's t with 4 degrees of freedom instead of a normal distribution
  double grossShare = 0;     // fraction of corners with gross errors [1]
  double grossSize = 8;      // size of gross errors [px]
  double displacedBoard = 0; // displacement of one board in one image [m]
};

/// Cameras with the manufacturer's field of view (focal length 598 px at a width of 640), without distortion.
std::map<std::string, CameraIntrinsics> nominalCameras(int width, int height);

/// Four A2 boards of 7x5 squares of 80 mm on the floor: near in front, left, right, and farther in front of a robot at
/// the origin that faces along x.
std::vector<Board> defaultBoards();

/// Half the distance between feet side by side [m].
constexpr double halfFootDistance = 0.05;

/// Mechanical and sensor properties common to all robots of a model.
struct RobotMechanics {
  int encoderSteps = 4096;               // per turn
  double encoderDither = radians(0.007); // 1 sigma, per reading [rad]
  double servoDroop = 1e-3;              // compliance of the motor under gravity [rad/Nm]
  double servoDeadZone = radians(0.1);   // resting error of a motor, 1 sigma, per approach [rad]
  double residualSpeed = 3e-4;           // residual speed at rest, 1 sigma [rad/s]
  double poseScatter = 0;                // gear deflection behind the encoder, 1 sigma, per pose (stiction) [rad]
  double approachScatter = 0;            // gear deflection, 1 sigma, per approach [rad]
  double imuNoise = 5e-3;                // [rad]
  double forceNoise = 0.02;              // [kg]
  double currentPerTorque = 0.25;        // [A/Nm]
  double currentNoise = 0.02;            // [A]
  double ambientTemperature = 30;        // [degC]
  double heatPerTorqueSquared = 1.5;     // steady-state rise above ambient [K/(Nm)^2]
  double thermalTimeConstant = 600;      // [s]
};

/// Simulation settings. Random values are uniform in [-range, range].
struct SimulationPlan {
  std::vector<CommandedPose> poses;
  int samples = 3; // per pose
  RepeatKind repeatKind = RepeatKind::rest;
  bool images = false;                    // images are rendered; no corners are given
  bool surveyed = false;                  // the set contains the placements of boards and stances
  double offsetRange = radians(6.5);      // per motor [rad]
  double mountRange = radians(2);         // per camera and axis [rad]
  double mountShiftRange = 0;             // per camera and axis [m]
  double boardShiftRange = 0.03;          // deviation from the board's `placement` [m]
  double boardTurnRange = 0.1;            // [rad]
  double stanceShiftRange = 0.04;         // deviation from the origin, per stance [m]
  double stanceTurnRange = 0.1;           // [rad]
  std::optional<std::uint64_t> robotSeed; // of offsets and mounts; reuses another set's robot
  std::optional<std::uint64_t> boardSeed; // of board placements; reuses another set's
  int firstStance = 0;                    // id of the first stance
  double flawScale = 1;                   // size of the defect: 1 is a worn NAO's
  bool hiddenFlaw = false;                // adds a random defect in the support leg
  std::string flaw = "";                  // a given defect instead: "gearPlay@LKneePitch"
  RobotMechanics mechanics;
  CornerNoise corners;
  std::map<std::string, CameraIntrinsics> cameras = nominalCameras(640, 480);
  std::vector<Board> boards = defaultBoards(); // with nominal placements
};

} // namespace naocal
