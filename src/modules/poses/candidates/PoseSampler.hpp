#pragma once

#include "measurements/Noise.hpp"
#include "poses/candidates/PoseOptions.hpp"
#include "poses/candidates/PoseValidity.hpp"
#include "poses/candidates/SupportLegs.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <vector>

namespace naocal {

/// How a robot stands.
struct ValidPose {
  ModelState belief;
  std::vector<double> point; // where in the ranges it was drawn from, one number in [0, 1] per range
  double standing = 0;       // share of robots with joint errors that stand so
  Eigen::VectorXd approach;  // per joint as in ProposedPose; empty: any
};

/// Draws attitudes of a standing robot from the ranges of PoseOptions, and sieves them.
class PoseSampler {
public:
  /// `first`: where in the sequence of attitudes to begin.
  PoseSampler(const Robot& robot, const PlanningScene& scene, const PoseOptions& options, std::size_t first = 0);

  /// One attempt; absent when anything is wrong with it, which `sieve` counts.
  std::optional<ValidPose> draw(PassCounts& sieve);

  /// The attitude at a point of the ranges, with no other glance than that.
  std::optional<ValidPose> sampleAt(const std::vector<double>& point, PassCounts& sieve);

  /// The robot at a point of the ranges, whether or not it stands there; absent where its legs do not reach it.
  std::optional<ModelState> stateAt(const std::vector<double>& point);

private:
  std::optional<ValidPose> attempt(int glances, PassCounts& sieve);
  /// Head: as drawn, else anywhere, until a board is in sight of the robot, which must remain stable.
  bool lookAround(ValidPose& attitude, int glances);
  void turnHead(ModelState& belief, const NumberSource& draw) const;

  double from(const Interval& interval); // by the next number of the point

  const Robot& robot_;
  const PlanningScene& scene_;
  PoseValidity checks_;
  StanceSampler legs_;
  std::vector<std::size_t> head_; // joints between the root and the cameras
  ModelState hanging_;            // all joints at rest
  std::unique_ptr<UnitCubeSampler> points_;
  std::vector<double> point_; // one number per range, the head's at the end
  std::size_t used_ = 0;      // of it
  std::mt19937_64 random_;    // robots with errors, and further glances
};

/// Valid poses, and how many attitudes it took.
struct PoseCandidates {
  std::vector<ValidPose> attitudes;
  PassCounts sieve;
};

/// Sieves `options.maxAttempts` attitudes on all cores. The same options give the same candidates on any number of cores.
/// `progress` is told how many were tried, now and then, by one thread at a time.
PoseCandidates samplePoses(const Robot& robot, const PlanningScene& scene, const PoseOptions& options,
                           const std::function<void(std::size_t)>& progress = {});

/// What each pose tells about the scene's unknowns (Scene::information), one picture of each camera: pixel noise, and
/// each joint's encoder error and scatter, which moves all corners of a pose together, integrated out.
std::vector<Eigen::MatrixXd> computeInformation(const Robot& robot, const PlanningScene& scene,
                                                const std::vector<ValidPose>& poses, const Noise& noise);

/// A pose in which the robot stands on one foot and sees a board.
struct PlannedPose {
  SupportFoot supportFoot = SupportFoot::left;
  Eigen::VectorXd angles;           // to be sent, one per joint of the drawing [rad]
  std::vector<VisibleBoard> sights; // by the drawn robot
};

/// A pose to be taken next.
struct ProposedPose {
  PlannedPose pose;         // its sights: as the fitted model predicts them
  Eigen::VectorXd approach; // per joint: the motion that ends in the pose, -1 from above, +1 from below
};

/// The first `count` attitudes that the draw finds acceptable (PoseOptions, PoseSampler), in the scene's terms;
/// fewer where `options.maxAttempts` do not suffice.
std::vector<ModelState> sampleStableStates(const Robot& robot, const PlanningScene& scene, const PoseOptions& options,
                                           std::size_t count);

/// Poses on one foot for boards around it (placements in the support sole's frame), arms hanging: within joint limits,
/// stable, the soles apart, a board in sight. Each is the most informative one beside those before it: greedily the
/// largest determinant of the information about offsets, cameras and boards. The same seed gives the same poses.
///
/// No part touches another; what hides a board is not looked at. Throws InputError when fewer than `count` are
/// found.
std::vector<PlannedPose> planInformativePoses(const Robot& robot, const std::vector<Board>& boards,
                                              const std::map<std::string, CameraIntrinsics>& cameras,
                                              const PoseOptions& options);

/// Errors per joint of robots whose motors are off, uniform within Stability::jointError either way [rad]; each
/// `number` gives others.
std::vector<Eigen::VectorXd> drawPerturbedRobots(const Robot& robot, const PoseOptions& options, std::size_t count,
                                                 std::uint64_t number);

/// How a robot with errors stands when the poses are commanded.
std::vector<ValidPose> applyErrors(const Eigen::VectorXd& errors, std::vector<ValidPose> poses);

} // namespace naocal
