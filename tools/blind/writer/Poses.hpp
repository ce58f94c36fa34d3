#pragma once

#include "writer/RandomStream.hpp"
#include "writer/Session.hpp"
#include "writer/Skeleton.hpp"

#include <functional>
#include <optional>

namespace blind {

/// The joints that move a camera over the standing sole: head and standing leg, hip yaw-pitch by its motor's name.
std::vector<int> chainOf(const Drawing& drawing, int side);

/// Places of A2 boards round the robot on which no two overlap.
std::vector<FloorPlace> placeBoards(int boards, RandomStream& chance);

/// Draws attitudes in which a robot stands on one foot without falling: bent somehow, then balanced at the ankle.
class PoseDrawer {
public:
  PoseDrawer(const Drawing& drawing, const Skeleton& skeleton) : drawing_{drawing}, skeleton_{skeleton} {}

  /// One of the cameras looks about at one of the targets (in the standing sole's frame). `worth` of an attitude: how
  /// much of the boards it sees; the best of some looks is taken, and none below `enough`. Hip yaw-pitch may be given.
  Eigen::VectorXd drawStable(int side, int camera, RandomStream& chance,
                             const std::vector<Eigen::Vector3d>& targetsInSole, double enough,
                             const std::function<double(const Eigen::VectorXd&)>& worth,
                             std::optional<double> hipYawPitch) const;

private:
  bool bend(int side, RandomStream& chance, std::optional<double> hipYawPitch, Eigen::VectorXd& angles) const;
  void look(int side, int camera, const Eigen::Vector3d& targetInSole, RandomStream& chance,
            Eigen::VectorXd& angles) const;
  bool balance(int side, const Eigen::Vector2d& target, Eigen::VectorXd& angles) const;
  bool withinLimits(const Eigen::VectorXd& angles) const;
  bool feetApart(int side, const Skeleton::Posture& posture) const;
  Eigen::Vector2d balancePoint(int side, const Eigen::VectorXd& angles) const;

  const Drawing& drawing_;
  const Skeleton& skeleton_;
};

} // namespace blind
