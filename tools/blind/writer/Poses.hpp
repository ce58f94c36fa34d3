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

/// A pose on one foot that shows boards to one camera.
struct PoseWish {
  int side, camera;
  std::vector<Eigen::Vector3d> targetsInSole;                 // the camera points roughly at one of them
  std::function<double(const Eigen::VectorXd& angles)> worth; // rates a pose by the visible corners
  double enough;                                              // least worth
  std::optional<double> hipYawPitch;                          // fixed value [rad]
};

/// Draws stable poses on one foot: random joint angles, balanced at the ankle.
class PoseDrawer {
public:
  PoseDrawer(const Drawing& drawing, const Skeleton& skeleton) : drawing_{drawing}, skeleton_{skeleton} {}

  /// The best of several head directions. Throws std::runtime_error if no pose is worth enough.
  Eigen::VectorXd drawStable(const PoseWish& wish, RandomStream& chance) const;

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
