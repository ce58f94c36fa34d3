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
struct SievedPose {
  Belief belief;
  std::vector<double> point; // where in the ranges it was drawn from, one number in [0, 1] per range
  double standing = 0;       // share of robots with joint errors that stand so
  Eigen::VectorXd approach;  // per joint as in ProposedPose; empty: any
};

/// Draws attitudes of a standing robot from the ranges of PoseOptions, and sieves them.
class RandomAttitude {
public:
  /// `first`: where in the sequence of attitudes to begin.
  RandomAttitude(const Robot& robot, const Scene& scene, const PoseOptions& options, std::size_t first = 0);

  /// One attempt; absent when anything is wrong with it, which `sieve` counts.
  std::optional<SievedPose> draw(Sieve& sieve);

  /// The attitude at a point of the ranges, with no other glance than that.
  std::optional<SievedPose> at(const std::vector<double>& point, Sieve& sieve);

  /// The robot at a point of the ranges, whether or not it stands there; absent where its legs do not reach it.
  std::optional<Belief> reached(const std::vector<double>& point);

private:
  std::optional<SievedPose> attempt(int glances, Sieve& sieve);
  /// Head: as drawn, else anywhere, until a board is in sight of the robot, which must remain stable.
  bool lookAround(SievedPose& attitude, int glances);
  void turnHead(Belief& belief, const DrawnNumber& draw) const;

  double from(const Interval& interval); // by the next number of the point

  const Robot& robot_;
  const Scene& scene_;
  PoseChecks checks_;
  StandingLegs legs_;
  std::vector<std::size_t> head_; // joints between the root and the cameras
  Belief hanging_;                // all joints at rest
  std::unique_ptr<UnitPoints> points_;
  std::vector<double> point_; // one number per range, the head's at the end
  std::size_t used_ = 0;      // of it
  std::mt19937_64 random_;    // robots with errors, and further glances
};

/// Valid poses, and how many attitudes it took.
struct PoseCandidates {
  std::vector<SievedPose> attitudes;
  Sieve sieve;
};

/// Sieves `options.tries` attitudes on all cores. The same options give the same candidates on any number of cores.
/// `progress` is told how many were tried, now and then, by one thread at a time.
PoseCandidates poseCandidates(const Robot& robot, const Scene& scene, const PoseOptions& options,
                              const std::function<void(std::size_t)>& progress = {});

/// What each pose tells about the scene's unknowns (Scene::information), one picture of each camera: pixel noise, and
/// each joint's encoder error and scatter, which moves all corners of a pose together, integrated out.
std::vector<Eigen::MatrixXd> informations(const Robot& robot, const Scene& scene, const std::vector<SievedPose>& poses,
                                          const Noise& noise);

/// A pose in which the robot stands on one foot and sees a board.
struct PlannedPose {
  SupportFoot supportFoot = SupportFoot::left;
  Eigen::VectorXd angles;    // to be sent, one per joint of the drawing [rad]
  std::vector<Sight> sights; // by the drawn robot
};

/// A pose to be taken next.
struct ProposedPose {
  PlannedPose pose;         // its sights: as the fitted model predicts them
  Eigen::VectorXd approach; // per joint: the motion that ends in the pose, -1 from above, +1 from below
};

/// The first `count` attitudes that the draw finds acceptable (PoseOptions, RandomAttitude), in the scene's terms;
/// fewer where `options.tries` do not suffice.
std::vector<Belief> stableAttitudes(const Robot& robot, const Scene& scene, const PoseOptions& options,
                                    std::size_t count);

/// Poses on one foot for boards around it (placements in the support sole's frame), arms hanging: within joint limits,
/// stable, the soles apart, a board in sight. Each is the most informative one beside those before it: greedily the
/// largest determinant of the information about offsets, cameras and boards. The same seed gives the same poses.
///
/// No part touches another; what hides a board is not looked at. Throws InputError when fewer than `count` are
/// found.
std::vector<PlannedPose> stablePoses(const Robot& robot, const std::vector<Board>& boards,
                                     const std::map<std::string, CameraIntrinsics>& cameras,
                                     const PoseOptions& options);

/// Errors per joint of robots whose motors are off, uniform within Stability::jointError either way [rad]; each
/// `number` gives others.
std::vector<Eigen::VectorXd> wornRobots(const Robot& robot, const PoseOptions& options, std::size_t count,
                                        std::uint64_t number);

/// How a robot with errors stands when the poses are commanded.
std::vector<SievedPose> takenBy(const Eigen::VectorXd& errors, std::vector<SievedPose> poses);

} // namespace naocal
