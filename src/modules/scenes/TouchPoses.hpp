#pragma once

#include "scenes/TrueRobot.hpp"

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

namespace naocal {

/// Finds poses in which a marker of the true robot touches a place: damped least squares on the joints between the
/// marker and the base, within their limits, from random poses.
class TouchPoses {
public:
  /// Keeps a reference.
  explicit TouchPoses(TrueRobot& robot) : robot_{robot} {}

  /// A pose that misses the place by `offset` in the world [m], found from a random one; `pose` gives time and
  /// deflection, and gets what the encoders read. `before`: what they read in the pose before, which says from where
  /// the joints come. Throws InputError if many random poses lead to none.
  TrueRobot::Pose find(std::size_t touch, const TrueRobot::Pose& pose, const Eigen::VectorXd& before,
                       const Eigen::Vector3d& offset);

  /// The same, from what the encoders read in a pose near it and from the same side; absent if nothing is found.
  std::optional<TrueRobot::Pose> findNear(std::size_t touch, const TrueRobot::Pose& pose,
                                          const Eigen::Vector3d& offset);

private:
  std::optional<TrueRobot::Pose> reach(std::size_t touch, TrueRobot::Pose pose, Eigen::VectorXd angles,
                                       const Eigen::VectorXd* before, const Eigen::Vector3d& offset);

  TrueRobot& robot_;
  Eigen::VectorXd last_; // angles of the pose that was found last [rad]
  double nearest_ = 0;   // of all that were tried for a touch [m]
};

} // namespace naocal
