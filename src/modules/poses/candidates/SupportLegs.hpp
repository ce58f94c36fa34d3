#pragma once

#include "data/Capture.hpp"
#include "poses/candidates/PoseOptions.hpp"
#include "robot/LegKinematics.hpp"
#include "robot/ModelState.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace naocal {

/// Leg kinematics of a robot on one foot.
class SingleSupport {
public:
  SingleSupport(const Robot& robot, SupportFoot supportFoot);

  /// Solves both legs so that torso and other sole have the given rotations, the torso the given height, and the centre
  /// of mass lies above `centre` in the support sole's frame [m]; the torso's x and y follow. False if out of reach.
  bool reachStance(ModelState& modelState, RigidTransform soleFromTorso, const RigidTransform& soleFromOther,
                   const Eigen::Vector2d& centre) const;

  const LegKinematics& supportLeg() const { return supportLeg_; }
  const LegKinematics& otherLeg() const { return otherLeg_; }
  /// Centre of the support sole's outline.
  const Eigen::Vector2d& outlineCentre() const { return middle_; }

private:
  bool bendLegs(ModelState& modelState, const RigidTransform& soleFromTorso, const RigidTransform& soleFromOther) const;

  const Robot& robot_;
  LegKinematics supportLeg_, otherLeg_;
  Eigen::Vector2d middle_;
};

/// Standing on both feet, feet flat, knees bent by 50 degrees, arms hanging [rad].
Eigen::VectorXd bentKneesStance(const Robot& robot);

/// Plans the motion from both feet onto one: the torso moves above the foot while the other foot stays on the floor,
/// then that foot is lifted. Returns waypoints (legs solved, other joints as in `stand`) [rad]; the last one is an
/// upright pose on one foot, from which other poses are reached. Throws InputError if the legs do not reach.
std::vector<Eigen::VectorXd> planOntoOneFoot(const Robot& robot, SupportFoot supportFoot, const Eigen::VectorXd& stand);

/// Waypoints between two poses on one foot, interpolating torso, other foot and centre of mass; this keeps the robot
/// balanced where interpolating joints does not. Returns `parts` - 1 waypoints [rad]; absent if out of reach. Does not
/// test whether the way is safe.
std::optional<std::vector<Eigen::VectorXd>> interpolateOnOneFoot(const Robot& robot, SupportFoot supportFoot,
                                                                 const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                                                 int parts);

/// Draws the next number in an interval.
using NumberSource = std::function<double(const Interval&)>;

/// Samples stances from the ranges of PoseOptions: on one foot with the other one lifted, or on both feet.
class StanceSampler {
public:
  StanceSampler(const Robot& robot, const PoseOptions& options);

  /// Number of values that `reachStance` draws.
  std::size_t dimension() const;
  /// Joints of both legs, support leg first.
  const std::vector<std::size_t>& joints() const { return joints_; }

  /// Draws a torso pose above the support sole, then shifts it until the centre of mass is at its drawn position. False
  /// if out of reach; does not test joint limits.
  bool reachStance(ModelState& modelState, const NumberSource& draw) const;

private:
  bool bendOnOne(ModelState& modelState, const NumberSource& draw) const;
  bool bendOnBoth(ModelState& modelState, const NumberSource& draw) const;
  void set(ModelState& modelState, const LegAngles& support, const LegAngles& other) const;
  /// Shifts the torso so that the centre of mass lies above `wanted` in the support sole's frame.
  void lean(const ModelState& modelState, const Eigen::Vector2d& wanted, RigidTransform& soleFromTorso) const;

  const Robot& robot_;
  const PoseOptions& options_;
  const Sole& other_;
  SingleSupport feet_;
  std::vector<std::size_t> joints_;
};

} // namespace naocal
