#pragma once

#include "poses/candidates/PoseSampler.hpp"
#include "poses/candidates/PoseValidity.hpp"

#include <optional>
#include <vector>

namespace naocal {

/// How a robot goes from pose to pose: all joints start and arrive together, the one with the longest way at `speed`, a
/// share of its full speed.
struct TransitionOptions {
  double share = 0.97; // of robots with joint errors that must stand all along
  double speed = 0.15; // a robot on one foot moves slowly
  double step = 0.03;  // at most this far between checks, of the joint that moves most [rad]
  double slip = 0.003; // on both feet: of a corner of the other sole, that gears and soles may give way [m]
};

/// From one pose to another (angles per joint), the slowest joint at a share `speed` of its full one [s].
double motionTime(const Robot& robot, const Eigen::VectorXd& from, const Eigen::VectorXd& to, double speed);

/// Looks at the way between poses.
class TransitionCheck {
public:
  TransitionCheck(const Robot& robot, const PoseOptions& options, const TransitionOptions& motion = {});
  TransitionCheck(const TransitionCheck&) = delete;
  TransitionCheck& operator=(const TransitionCheck&) = delete;

  /// Of the motion from one to the other; absent where the robot, or too many of those with joint errors, would fall
  /// over or touch itself on the way, or a foot of both would slide.
  std::optional<double> duration(const Eigen::VectorXd& from, const Eigen::VectorXd& to) const;

private:
  bool isSliding(const LinkPoses& before, const LinkPoses& now) const;

  const Robot& robot_;
  TransitionOptions motion_;
  PoseOptions options_; // on the way
  PoseValidity checks_;
};

/// The quickest order to visit all poses, one after another: exact for up to 12 poses, else always the nearest next.
/// `seconds[i][j]`: from i to j, absent where there is no way. Absent: there is no such order.
std::optional<std::vector<std::size_t>>
findQuickestOrder(const std::vector<std::vector<std::optional<double>>>& seconds);

/// Straight on from pose to pose in the quickest order, and a rest in each [s]; whether the ways are safe is not looked
/// at.
double playTime(const Robot& robot, const std::vector<ValidPose>& poses, double secondsPerPose);

/// A safe way from one pose to another.
struct Transition {
  std::vector<Eigen::VectorXd> via; // angles to pass through on the way, none: straight on [rad]
  double seconds = 0;
};

/// Straight on where that is safe; else along the line between the poses' points in the ranges that they were drawn
/// from, which keeps the centre of mass over the foot. Absent: neither is safe.
std::optional<Transition> findTransition(const Robot& robot, const PlanningScene& scene, const PoseOptions& options,
                                         const TransitionCheck& checks, const ValidPose& from, const ValidPose& to);

/// Poses in the quickest safe order, and the way to each from the one before it; absent: the first, or none is safe.
struct OrderedPoses {
  std::vector<ValidPose> poses;
  std::vector<std::optional<Transition>> ways;
};

/// Where there is no safe way through all of them the order is as given.
OrderedPoses orderPoses(const Robot& robot, const PlanningScene& scene, const PoseOptions& options,
                        std::vector<ValidPose> poses);

} // namespace naocal
