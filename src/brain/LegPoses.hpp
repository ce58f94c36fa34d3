#pragma once

#include "brain/CalibrationStep.hpp"
#include "poses/PoseFile.hpp"
#include "poses/candidates/SingleSupportPlanner.hpp"
#include "robot/Robot.hpp"

namespace naocal {

/// The poses of a pose file that a robot takes on one foot, each reached from standing upright on that foot, so that
/// they can be taken in any order (OneFootWays), by robots with joints off by what the file says,
/// at most 6.5 degrees as in `naocal poses`: poses may be safe for more than ways are.
class LegPoses {
public:
  /// `stand`: on both feet. Throws InputError for a foot that the file has no poses for, and for poses without a safe
  /// way to them.
  LegPoses(const Robot& drawing, const PoseFile& file, SupportFoot foot, const CompensatedAngles& stand);

  /// Onto the foot, through the poses in random order, and back to the stand; held by a person between one foot and
  /// both, for its joints may be off by degrees, and since the foot before where this is not the first stance (0). In
  /// each pose pictures are taken at as many approaches as asked, from below and from above in turn: which joint comes
  /// from where first is random.
  CalibrationRound round(const RoundOptions& options, int stance) const;

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
