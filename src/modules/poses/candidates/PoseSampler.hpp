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

/// A valid standing pose.
struct ValidPose {
  ModelState modelState;
  std::vector<double> point; // coordinates in the sampling ranges, each in [0, 1]
  double standing = 0;       // fraction of robots with joint errors that stay balanced
  Eigen::VectorXd approach;  // per joint as in ProposedPose; empty: any
};

/// Samples standing poses from the ranges of PoseOptions and filters them.
class PoseSampler {
public:
  /// `first`: index in the sample sequence to start from.
  PoseSampler(const Robot& robot, const PlanningScene& scene, const PoseOptions& options, std::size_t first = 0);

  /// One sample; absent if a test rejects it, as counted in `sieve`.
  std::optional<ValidPose> draw(PassCounts& sieve);

  /// The pose at a point of the ranges, without alternative head directions.
  std::optional<ValidPose> sampleAt(const std::vector<double>& point, PassCounts& sieve);

  /// The state at a point of the ranges, without tests of balance; absent if out of reach or beyond joint limits.
  std::optional<ModelState> stateAt(const std::vector<double>& point);

private:
  std::optional<ValidPose> attempt(int glances, PassCounts& sieve);
  /// Turns the head, first as sampled, then at random up to `glances` - 1 times, until a board is visible and the robot
  /// is stable.
  bool lookAround(ValidPose& attitude, int glances);
  void turnHead(ModelState& modelState, const NumberSource& draw) const;

  double from(const Interval& interval); // scales the next coordinate to the interval

  const Robot& robot_;
  const PlanningScene& scene_;
  PoseValidity checks_;
  StanceSampler legs_;
  std::vector<std::size_t> head_; // joints between the root and the cameras
  ModelState hanging_;            // all joints at rest
  std::unique_ptr<UnitCubeSampler> points_;
  std::vector<double> point_; // one coordinate per range, the head's last
  std::size_t used_ = 0;      // coordinates used so far
  std::mt19937_64 random_;    // for robots with joint errors and further head directions
};

/// Valid poses and the counts of the filters.
struct PoseCandidates {
  std::vector<ValidPose> attitudes;
  PassCounts sieve;
};

/// Filters `options.maxAttempts` samples on all cores. Reproducible by seed for any number of cores. Calls `progress`
/// with the number of samples done, from one thread at a time.
PoseCandidates samplePoses(const Robot& robot, const PlanningScene& scene, const PoseOptions& options,
                           const std::function<void(std::size_t)>& progress = {});

/// Each pose's information about the scene's unknowns (PlanningScene::information), for one image per camera: includes
/// pixel noise, and marginalises each joint's encoder error and joint scatter, which move all corners of a pose
/// together.
std::vector<Eigen::MatrixXd> computeInformation(const Robot& robot, const PlanningScene& scene,
                                                const std::vector<ValidPose>& poses, const Noise& noise);

/// A pose in which the robot stands and is measured.
struct PlannedPose {
  SupportFoot supportFoot = SupportFoot::left;
  Eigen::VectorXd angles;                // motor command without offsets, per joint of the drawing [rad]
  std::vector<VisibleBoard> sights;      // for the drawn robot
  std::vector<std::string> tracked = {}; // markers and frames that a tracker sees
};

/// A planned pose and its approach.
struct ProposedPose {
  PlannedPose pose;         // sights: predicted by the fitted model
  Eigen::VectorXd approach; // per joint: direction of the final motion, -1 from above, +1 from below
};

/// The first `count` valid poses (PoseOptions, PoseSampler) as states of the scene; fewer if `options.maxAttempts`
/// samples do not suffice.
std::vector<ModelState> sampleStableStates(const Robot& robot, const PlanningScene& scene, const PoseOptions& options,
                                           std::size_t count);

/// Plans poses on one foot for boards around it (placements in the support sole's frame), arms hanging: within joint
/// limits, stable, soles apart, a board visible, without self-collision. Selection is greedy and D-optimal: each pose
/// maximises the determinant of the information about offsets, cameras and boards. Reproducible by seed.
///
/// Occlusion of boards is not tested. Throws InputError if fewer than `count` are found.
std::vector<PlannedPose> planInformativePoses(const Robot& robot, const std::vector<Board>& boards,
                                              const std::map<std::string, CameraIntrinsics>& cameras,
                                              const PoseOptions& options);

/// Draws joint errors of robots, uniform within +-BalanceRequirement::jointError [rad], equal for joints of one motor;
/// each `number` gives another sample.
std::vector<Eigen::VectorXd> drawPerturbedRobots(const Robot& robot, const PoseOptions& options, std::size_t count,
                                                 std::uint64_t number);

/// Poses taken by a robot with joint errors: adds `errors` to the commanded angles.
std::vector<ValidPose> applyErrors(const Eigen::VectorXd& errors, std::vector<ValidPose> poses);

} // namespace naocal
