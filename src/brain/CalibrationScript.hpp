#pragma once

#include "data/Capture.hpp"
#include "hardware/messages/CompensatedAngles.hpp"
#include "poses/PoseFile.hpp"
#include "poses/candidates/SingleSupportPlanner.hpp"
#include "robot/Robot.hpp"

#include <vector>

namespace naocal {

/// A step of a calibration's round.
struct CalibrationStep {
  std::string name;                      // of where it leads, for people
  std::string question;                  // to the person, answered before it begins; empty: none
  bool held = false;                     // a person holds the robot on the way, until the next step begins
  std::vector<CompensatedAngles> points; // to go through and stay at the last one; none: back to the stand
  int pictures = 0;                      // of each camera, taken there
  Capture taken;                         // what all captures of the step have in common: pose, repeat, foot, stance
};

/// The poses of a round of a calibration, one after another.
using CalibrationRound = std::vector<CalibrationStep>;

/// How a round is taken.
struct RoundOptions {
  int pictures = 2;       // of each camera in each pose; on one foot each at an approach of its own
  double approach = 0;    // from how far each joint comes, once from each side [rad]
  std::size_t poses = 0;  // the first so many of them in the round's random order; 0: all
  std::uint64_t seed = 1; // of that order
};

/// The stand with the head turned [deg].
CompensatedAngles turnHead(const CompensatedAngles& stand, double yaw, double pitch);

/// The stand with the head at each pair of these angles [deg] times `share`, in random order; pictures are taken at as
/// many approaches as asked, of yaw and pitch from below and from above in turn.
CalibrationRound planHeadRound(const CompensatedAngles& stand, const std::vector<double>& yaws,
                               const std::vector<double>& pitches, double share, const RoundOptions& options);

/// The poses of a pose file that a robot takes on one foot, each reached from standing upright on that foot, so that
/// they can be taken in any order (OneFootWays), by robots with joints off by what the file says,
/// at most 6.5 degrees as in `naocal poses`: poses may be safe for more than ways are.
class LegRoundPlanner {
public:
  /// `stand`: on both feet. Throws InputError for a foot that the file has no poses for, and for poses without a safe
  /// way to them.
  LegRoundPlanner(const Robot& drawing, const PoseFile& file, SupportFoot foot, const CompensatedAngles& stand);

  /// Onto the foot, through the poses in random order, and back to the stand; held by a person between one foot and
  /// both, for its joints may be off by degrees, and since the foot before where this is not the first stance (0). In
  /// each pose pictures are taken at as many approaches as asked, from below and from above in turn: which joint comes
  /// from where first is random.
  CalibrationRound planRound(const RoundOptions& options, int stance) const;

private:
  /// Onto the foot, upright: held by a person, who then puts the robot down and lets it go.
  CalibrationRound onto(bool isHeld) const;
  OneFootWays::Approach approach(const PlayablePose& pose, double distance, std::mt19937_64& random) const;
  CompensatedAngles robotAngles(const Eigen::VectorXd& angles) const;

  const Robot& drawing_;
  SupportFoot foot_;
  OneFootWays ways_;
  std::vector<PlayablePose> poses_;
};

} // namespace naocal
