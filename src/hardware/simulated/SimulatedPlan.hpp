#pragma once

#include "hardware/RobotInterface.hpp"
#include "hardware/simulated/Servo.hpp"
#include "simulation/Renderer.hpp"
#include "simulation/RobotErrors.hpp"
#include "simulation/SimulationPlan.hpp"

#include <filesystem>

namespace naocal {

/// How time passes for a simulated robot.
enum class Pace {
  real,  // as on the wall
  quick, // as fast as the program: the next cycle comes when this one is answered, and no picture is taken before the
         // camera loop asks for another one. The same program gets the same states and pictures every time
};

/// The cameras of a simulated robot.
struct SimulatedCameraPlan {
  std::map<std::string, CameraIntrinsics> intrinsics = nominalCameras(640, 480); // "top", "bottom"
  Seconds period{1.0 / 30};
  Seconds exposure{0.010};
  Seconds readOut{0.024};  // from the first row to the last one: rolling shutter
  Seconds transfer{0.005}; // from the end of the last row to the program
  Seconds jitter{0};       // sigma of when a picture is taken against its schedule
  double lostShare = 0;    // of pictures that the driver loses, seen as gaps in their sequence [1]
  Appearance appearance;
};

/// What to simulate. Ranges are drawn uniformly from [-range, range], play from [0, range], by the seed.
struct SimulatedPlan {
  std::string model = "V6";
  std::uint64_t seed = 1;
  double offsetRange = radians(5); // per motor [rad]
  double mountRange = radians(2);  // per camera and axis [rad]
  double mountShiftRange = 0;      // per camera and axis [m]
  double playRange = 0;            // of each gear [rad]
  RobotMechanics mechanics;        // sensors, heat
  ServoMechanics servos;
  Seconds commandDelay{0.02}; // from a command to the motors
  SimulatedCameraPlan cameras;
  std::vector<Board> boards = defaultBoards(); // lie where `placement` says
  RawAngles start = standingAngles();          // what the motors were commanded to before
  Pace pace = Pace::real;

  /// Upright on both feet with bent knees and hanging arms [rad].
  static RawAngles standingAngles();
};

/// What a simulated robot has that nobody told it.
struct SimulatedErrors {
  RobotErrors robot;
  std::vector<double> play; // per joint: of its motor's gear [rad]
};

/// Drawn by the plan's seed.
SimulatedErrors drawErrors(const Robot& drawing, const SimulatedPlan& plan);

/// Reads what to simulate. All keys may be missing; what they would say is as in `plan`:
///
///     {"model": "V6", "seed": 1, "pace": "real",                                  or "quick"
///      "offsetRangeDegrees": 5, "mountRangeDegrees": 2, "playRangeDegrees": 0,    hidden errors, drawn by the seed
///      "droopDegreesPerNewtonMetre": 0.057,
///      "exposureSeconds": 0.01, "readOutSeconds": 0.024, "jitterSeconds": 0, "lostShare": 0, "pictureNoise": 3,
///      "boards": [...]}                                                           as in a capture set, with placements
///
/// Throws InputError: file, place, what was expected, what was found.
SimulatedPlan readSimulatedPlan(const std::filesystem::path& file, SimulatedPlan plan = {});

} // namespace naocal
