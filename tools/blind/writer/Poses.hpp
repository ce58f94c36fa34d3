#pragma once

#include "world/RandomStream.hpp"
#include "world/Session.hpp"
#include "world/Skeleton.hpp"

#include <functional>
#include <optional>

namespace blind {

/// Joints between the support sole and the cameras: head and support leg; hip yaw-pitch by its motor's name.
std::vector<int> chainOf(const Drawing& drawing, int side);

/// Non-overlapping places of A2 boards around the robot.
std::vector<FloorPlace> placeBoards(int boards, RandomStream& chance);

/// Draws stable poses on one foot: random joint angles, balanced at the ankle.
class PoseDrawer {
public:
  PoseDrawer(const Drawing& drawing, const Skeleton& skeleton) : drawing_{drawing}, skeleton_{skeleton} {}

  /// Points one camera roughly at one of the targets (support sole frame). `worth` rates a pose by the visible corners;
  /// returns the best of several head directions, better than `enough`. `hipYawPitch`: fixed value. Throws
  /// std::runtime_error if no pose is found.
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
