#pragma once

#include "poses/OneFoot.hpp"
#include "poses/PoseOptions.hpp"

#include <functional>
#include <vector>

namespace naocal {

/// The next number, in an interval.
using DrawnNumber = std::function<double(const Interval&)>;

/// Bends legs until a robot stands as the ranges of PoseOptions have it: on one foot, the other one lifted, or on both.
class StandingLegs {
public:
  StandingLegs(const Robot& robot, const PoseOptions& options);

  /// How many numbers `bend` draws.
  std::size_t ranges() const;
  /// Of both legs.
  const std::vector<std::size_t>& joints() const { return joints_; }

  /// The torso somewhere over the support sole, then moved until the centre of mass is where it was drawn. False: out
  /// of the legs' reach; joints' limits are not judged.
  bool bend(Belief& belief, const DrawnNumber& draw) const;

private:
  bool bendOnOne(Belief& belief, const DrawnNumber& draw) const;
  bool bendOnBoth(Belief& belief, const DrawnNumber& draw) const;
  void set(Belief& belief, const LegAngles& support, const LegAngles& other) const;
  /// Moves the torso until the centre of mass of the robot is over `wanted` in the support sole's frame.
  void lean(const Belief& belief, const Eigen::Vector2d& wanted, RigidTransform& soleFromTorso) const;

  const Robot& robot_;
  const PoseOptions& options_;
  const Sole& other_;
  OneFoot feet_;
  std::vector<std::size_t> joints_;
};

} // namespace naocal
