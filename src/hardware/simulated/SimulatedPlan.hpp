#pragma once

#include "hardware/RobotInterface.hpp"
#include "hardware/simulated/Servo.hpp"
#include "simulation/Renderer.hpp"
#include "simulation/RobotErrors.hpp"
#include "simulation/SimulationPlan.hpp"

#include <filesystem>

namespace naocal {

/// Speed of a simulated robot's time.
enum class Pace {
  real,  // wall time
  quick, // as fast as the program: the next cycle starts when the previous one is answered, and no image is taken
         // before the camera loop waits for one. Reproducible states and images
};

/// Cameras of a simulated robot.
struct SimulatedCameraPlan {
  std::map<std::string, CameraIntrinsics> intrinsics = nominalCameras(640, 480); // "top", "bottom"
  Seconds period{1.0 / 30};
  Seconds exposure{0.010};
  Seconds readOut{0.024};  // from the first to the last row: rolling shutter
  Seconds transfer{0.005}; // from the end of the last row to arrival
  Seconds jitter{0};       // deviation from the schedule, 1 sigma
  double lostShare = 0;    // fraction of images lost by the driver, visible as gaps in the sequence [1]
  Appearance appearance;
};

/// Simulation settings. Errors are drawn by the seed, uniformly from [-range, range], play from [0, range].
struct SimulatedPlan {
  std::string model = "V6";
  std::uint64_t seed = 1;
  double offsetRange = radians(5); // per motor [rad]
  double mountRange = radians(2);  // per camera and axis [rad]
  double mountShiftRange = 0;      // per camera and axis [m]
  double playRange = 0;            // per gear [rad]
  RobotMechanics mechanics;        // sensors, heat
  ServoMechanics servos;
  Seconds commandDelay{0.02}; // from a command to the motors' reaction
  SimulatedCameraPlan cameras;
  std::vector<Board> boards = defaultBoards(); // each with `placement`
  RawAngles start = standingAngles();          // motor angles at the start
  Pace pace = Pace::real;

  /// Standing on both feet with bent knees and hanging arms [rad].
  static RawAngles standingAngles();
};

/// Ground truth errors of a simulated robot.
struct SimulatedErrors {
  RobotErrors robot;
  std::vector<double> play; // per joint: play of its motor's gear [rad]
};

/// Draws the errors with the plan's seed.
SimulatedErrors drawErrors(const Robot& drawing, const SimulatedPlan& plan);

/// Reads simulation settings. Missing keys keep the values of `plan`:
///
///     {"model": "V6", "seed": 1, "pace": "real",                                  or "quick"
///      "offsetRangeDegrees": 5, "mountRangeDegrees": 2, "playRangeDegrees": 0,    hidden errors, drawn by the seed
///      "droopDegreesPerNewtonMetre": 0.057,
///      "periodSeconds": 0.033, "exposureSeconds": 0.01, "readOutSeconds": 0.024,  of a camera's pictures
///      "jitterSeconds": 0, "lostShare": 0, "pictureNoise": 3,
///      "boards": [...]}                                                           as in a capture set, with placements
///
/// Throws InputError that gives file, place, expectation and finding.
SimulatedPlan readSimulatedPlan(const std::filesystem::path& file, SimulatedPlan plan = {});

} // namespace naocal
