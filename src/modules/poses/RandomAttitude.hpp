#pragma once

#include "model/LegInverseKinematics.hpp"
#include "poses/PoseOptions.hpp"

#include <optional>
#include <random>
#include <vector>

namespace naocal {

/// Draws attitudes of a robot on one foot.
class RandomAttitude {
public:
  RandomAttitude(const Robot& robot, const Scene& scene, const PoseOptions& options);

  /// One attempt; absent when anything is wrong with it. The cheapest checks come first.
  std::optional<Belief> draw();

private:
  /// Legs: the torso somewhere over the support sole, then moved until the centre of mass is where it was drawn.
  bool standUp(Belief& belief);
  bool bendLegs(Belief& belief, const RigidTransform& soleFromTorso, const RigidTransform& soleFromOther) const;
  /// Head: anywhere, until a board is in sight.
  bool lookAround(Belief& belief);

  template <typename Joints> bool withinLimits(const Belief& belief, const Joints& joints) const;
  /// Seen from above: a lifted foot over the other one would strike its ankle.
  bool solesApart(const Posture& torsoFromLink) const;
  double from(const Interval& interval);

  const Robot& robot_;
  const Scene& scene_;
  const PoseOptions& options_;
  const Sole &support_, &other_;
  Leg supportLeg_, otherLeg_;
  std::vector<std::size_t> head_; // joints between the root and the cameras
  Belief hanging_;                // all joints at rest, as far as their limits let them
  std::mt19937_64 random_;
};

} // namespace naocal
