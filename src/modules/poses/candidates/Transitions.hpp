#pragma once

#include "poses/candidates/PoseSampler.hpp"
#include "poses/candidates/PoseValidity.hpp"

#include <optional>
#include <vector>

namespace naocal {

/// Motion between poses: all joints start and stop together; the slowest joint moves at `speed`, a fraction of its
/// maximum speed.
struct TransitionOptions {
  double share = 0.97; // fraction of robots with joint errors that must stay balanced throughout
  double speed = 0.15; // of the maximum; low, for a robot on one foot
  double step = 0.03;  // largest change of a joint between checks [rad]
  double slip = 0.003; // on both feet: largest motion of a corner of the other sole, absorbed by gears and soles [m]
};

/// Duration of a motion between poses (angles per joint), the slowest joint at the fraction `speed` of its maximum [s].
double motionTime(const Robot& robot, const Eigen::VectorXd& from, const Eigen::VectorXd& to, double speed);

/// Safety test of straight motions between poses.
class TransitionCheck {
public:
  TransitionCheck(const Robot& robot, const PoseOptions& options, const TransitionOptions& motion = {});
  TransitionCheck(const TransitionCheck&) = delete;
  TransitionCheck& operator=(const TransitionCheck&) = delete;

  /// Duration of the motion [s]; absent if the robot, or too many of those with joint errors, would fall or touch
  /// itself, or if a foot would slide on both feet.
  std::optional<double> duration(const Eigen::VectorXd& from, const Eigen::VectorXd& to) const;

private:
  bool isSliding(const LinkPoses& before, const LinkPoses& now) const;

  const Robot& robot_;
  TransitionOptions motion_;
  PoseOptions options_; // tolerances on the way
  PoseValidity checks_;
};

/// The quickest order of all poses: exact for up to 12 poses, otherwise nearest neighbour. `seconds[i][j]`: from i to
/// j, absent if there is no way. Absent if no order exists.
std::optional<std::vector<std::size_t>>
findQuickestOrder(const std::vector<std::vector<std::optional<double>>>& seconds);

/// Duration of straight motions in the quickest order, plus a rest in each pose [s]; does not test whether the ways are
/// safe.
double playTime(const Robot& robot, const std::vector<ValidPose>& poses, double secondsPerPose);

/// A safe way between two poses.
struct Transition {
  std::vector<Eigen::VectorXd> via; // waypoints, empty: direct [rad]
  double seconds = 0;
};

/// Poses in the quickest safe order, and the way to each from the previous one; absent: first pose, or no safe way.
struct OrderedPoses {
  std::vector<ValidPose> poses;
  std::vector<std::optional<Transition>> ways;
};

/// Keeps the given order if there is no safe way through all poses.
OrderedPoses orderPoses(const Robot& robot, const PlanningScene& scene, const PoseOptions& options,
                        std::vector<ValidPose> poses);

} // namespace naocal
