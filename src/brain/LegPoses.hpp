#pragma once

#include "brain/CalibrationStep.hpp"
#include "model/Robot.hpp"
#include "poses/OneFoot.hpp"
#include "poses/PoseFile.hpp"
#include "poses/PoseOrder.hpp"

namespace naocal {

/// The poses of a pose file that a robot takes on one foot, each reached from standing upright on that foot, so that
/// they can be taken in any order. What is asked of the ways is what `naocal poses` asks: of robots with joints off by
/// 6.5 degrees 97 of 100 stand all along, and no part touches another.
class LegPoses {
public:
  /// `stand`: on both feet. Throws InputError for a foot that the file has no poses for, and for poses without a safe
  /// way to them.
  LegPoses(const Robot& drawing, const PoseFile& file, SupportFoot foot, const CompensatedAngles& stand);

  /// Onto the foot, through the poses in random order, and back to the stand. In each pose pictures are taken at as
  /// many approaches as asked, from below and from above in turn: which joint comes from where first is random.
  CalibrationRound round(const RoundOptions& options, int stance) const;

private:
  using Way = std::vector<Eigen::VectorXd>; // angles to pass through, the last ones where it leads
  struct Approach {
    Eigen::VectorXd side; // per joint: which way it turns into the pose, -1 or +1; 0: one that is not calibrated
    Way way;              // from standing upright to where the approach begins
  };
  Approach approach(const PlayablePose& pose, double distance, std::mt19937_64& random) const;
  std::optional<Way> safeWay(const Eigen::VectorXd& to) const;
  CompensatedAngles robotAngles(const Eigen::VectorXd& angles) const;

  const Robot& drawing_;
  SupportFoot foot_;
  PoseOptions options_;
  WayChecks ways_;
  std::vector<Eigen::VectorXd> ontoFoot_;
  std::vector<PlayablePose> poses_;
};

} // namespace naocal
