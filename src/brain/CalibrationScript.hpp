#pragma once

#include "data/Capture.hpp"
#include "hardware/messages/CompensatedAngles.hpp"
#include "poses/PoseFile.hpp"
#include "poses/candidates/SingleSupportPlanner.hpp"
#include "robot/Robot.hpp"

#include <vector>

namespace naocal {

/// One step of a calibration round.
struct CalibrationStep {
  std::string name;                      // name of the target, for display
  std::string question;                  // question to the operator, confirmed before the step; empty: none
  bool held = false;                     // a person holds the robot from here until the next step begins
  std::vector<CompensatedAngles> points; // waypoints; the robot stays at the last one; empty: back to the stand
  int pictures = 0;                      // per camera, at the last waypoint
  Capture taken;                         // common fields of the step's captures: pose, repeat, foot, stance
};

/// The poses of one calibration round, in order.
using CalibrationRound = std::vector<CalibrationStep>;

/// Options of a round.
struct RoundOptions {
  int pictures = 2;       // per camera and pose; on one foot, each with a separate approach
  double approach = 0;    // distance of the approach per joint, alternating sides [rad]
  std::size_t poses = 0;  // number of poses taken, in the round's random order; 0: all
  std::uint64_t seed = 1; // of the random order
};

/// The stand with the head turned; `yaw`, `pitch` [deg].
CompensatedAngles turnHead(const CompensatedAngles& stand, double yaw, double pitch);

/// The stand with the head at each pair of `yaws` and `pitches` [deg], scaled by `share`, in random order. Each pose is
/// approached `options.pictures` times, yaw and pitch from below and from above in turn.
CalibrationRound planHeadRound(const CompensatedAngles& stand, const std::vector<double>& yaws,
                               const std::vector<double>& pitches, double share, const RoundOptions& options);

/// Plans the single-support poses of a pose file for one foot. Each pose is reached from standing upright on that foot,
/// so that any order is possible (SingleSupportPlanner). Ways tolerate joint errors up to the file's `jointError`,
/// limited to the default of `naocal poses` (6.5 degrees): poses may tolerate larger errors than ways do.
class LegRoundPlanner {
public:
  /// `stand`: on both feet. Throws InputError if the file has no poses for the foot. `planRound` throws it if a pose
  /// has no safe way.
  LegRoundPlanner(const Robot& drawing, const PoseFile& file, SupportFoot foot, const CompensatedAngles& stand);

  /// Plans the way onto the foot, through the poses in random order, and back to the stand. A person holds the robot
  /// between one foot and both, because its joints may be off by degrees; in a later stance (`stance` > 0) also since
  /// the previous foot. Each pose is approached `options.pictures` times, from below and from above in turn; each
  /// joint's first side is random.
  CalibrationRound planRound(const RoundOptions& options, int stance) const;

private:
  /// Steps onto the foot, upright. A person holds the robot, puts it down and lets go; `isHeld`: holds it already.
  CalibrationRound onto(bool isHeld) const;
  SingleSupportPlanner::Approach approach(const PlayablePose& pose, double distance, std::mt19937_64& random) const;
  CompensatedAngles robotAngles(const Eigen::VectorXd& angles) const;

  const Robot& drawing_;
  SupportFoot foot_;
  SingleSupportPlanner ways_;
  std::vector<PlayablePose> poses_;
};

} // namespace naocal
