#pragma once

#include "data/Capture.hpp"
#include "poses/candidates/PoseOptions.hpp"
#include "robot/LegKinematics.hpp"
#include "robot/ModelState.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace naocal {

/// The legs of a robot that stands on one foot.
class SingleSupport {
public:
  SingleSupport(const Robot& robot, SupportFoot supportFoot);

  /// Bends both legs so that torso and other sole are turned as wanted, the torso is at the height wanted, and the
  /// centre of mass is over a point of the support sole [m]; where the torso is forwards and sideways follows. False
  /// where the legs do not reach.
  bool reachStance(ModelState& belief, RigidTransform soleFromTorso, const RigidTransform& soleFromOther,
                   const Eigen::Vector2d& centre) const;

  const LegKinematics& supportLeg() const { return supportLeg_; }
  const LegKinematics& otherLeg() const { return otherLeg_; }
  /// Of the support sole's outline.
  const Eigen::Vector2d& outlineCentre() const { return middle_; }

private:
  bool bendLegs(ModelState& belief, const RigidTransform& soleFromTorso, const RigidTransform& soleFromOther) const;

  const Robot& robot_;
  LegKinematics supportLeg_, otherLeg_;
  Eigen::Vector2d middle_;
};

/// Standing on both feet, feet flat and knees bent by 50 degrees, arms hanging [rad].
Eigen::VectorXd bentKneesStance(const Robot& robot);

/// How a robot that stands on both feet comes onto one: the torso moves over the foot while the other one stays on the
/// floor, then that one is lifted. The angles to pass through (per joint, legs as they must be, the rest as in
/// `stand`) [rad]; the last ones are a pose on one foot, upright, from which others are reached.
///
/// Throws InputError for a robot whose legs do not reach that.
std::vector<Eigen::VectorXd> planOntoOneFoot(const Robot& robot, SupportFoot supportFoot, const Eigen::VectorXd& stand);

/// Angles to pass through from one pose on a foot to another one, so that torso, other foot and centre of mass move
/// evenly, which keeps the robot over its foot where joints that move evenly do not; `parts` - 1 of them [rad]. Absent
/// where the legs do not reach. Whether the way is safe is not looked at.
std::optional<std::vector<Eigen::VectorXd>> interpolateOnOneFoot(const Robot& robot, SupportFoot supportFoot,
                                                                 const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                                                 int parts);

/// The next number, in an interval.
using NumberSource = std::function<double(const Interval&)>;

/// Bends legs until a robot stands as the ranges of PoseOptions have it: on one foot, the other one lifted, or on both.
class StanceSampler {
public:
  StanceSampler(const Robot& robot, const PoseOptions& options);

  /// How many numbers `reachStance` draws.
  std::size_t dimension() const;
  /// Of both legs.
  const std::vector<std::size_t>& joints() const { return joints_; }

  /// The torso somewhere over the support sole, then moved until the centre of mass is where it was drawn. False: out
  /// of the legs' reach; joints' limits are not judged.
  bool reachStance(ModelState& belief, const NumberSource& draw) const;

private:
  bool bendOnOne(ModelState& belief, const NumberSource& draw) const;
  bool bendOnBoth(ModelState& belief, const NumberSource& draw) const;
  void set(ModelState& belief, const LegAngles& support, const LegAngles& other) const;
  /// Moves the torso until the centre of mass of the robot is over `wanted` in the support sole's frame.
  void lean(const ModelState& belief, const Eigen::Vector2d& wanted, RigidTransform& soleFromTorso) const;

  const Robot& robot_;
  const PoseOptions& options_;
  const Sole& other_;
  SingleSupport feet_;
  std::vector<std::size_t> joints_;
};

} // namespace naocal
