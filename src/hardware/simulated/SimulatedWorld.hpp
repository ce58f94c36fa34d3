#pragma once

#include "hardware/CameraInterface.hpp"
#include "hardware/RobotInterface.hpp"
#include "hardware/simulated/SimulatedPlan.hpp"

#include <memory>

namespace naocal {

struct SimulatedShared;

/// A simulated robot in front of its boards: one world behind two interfaces, for two threads. Only `waitForState`
/// advances time, so the camera loop times out without a running motion loop.
class SimulatedWorld {
public:
  /// `drawing`: robot of the plan's model.
  SimulatedWorld(const Robot& drawing, const SimulatedPlan& plan);
  ~SimulatedWorld();
  SimulatedWorld(const SimulatedWorld&) = delete;
  SimulatedWorld& operator=(const SimulatedWorld&) = delete;

  /// The interfaces for the motion and the camera thread; they may outlive this object. With `Pace::quick` the world
  /// waits for the camera loop as long as `cameras` lives, but at most 2 s for a loop that does not call it.
  std::unique_ptr<RobotInterface> robot();
  std::unique_ptr<CameraInterface> cameras();

  /// Ground truth.
  const SimulatedErrors& errors() const;

  /// The true state at this moment; thread-safe.
  struct Truth {
    TimePoint time;
    Eigen::VectorXd joints; // of the drawing [rad]
    Eigen::Isometry3d worldFromTorso;
    SupportFoot supportFoot = SupportFoot::both;
    bool fallen = false;
  };
  Truth truth() const;

  /// True joint angles [rad], linear between quarters of cycles; absent outside the last second. Thread-safe.
  std::optional<Eigen::VectorXd> jointsAt(TimePoint time) const;

  /// Sets the simulated touch sensors until the next call; thread-safe.
  void touch(const Touch& touch);

  /// Stops or resumes a camera's images; thread-safe.
  void block(CameraName camera, bool blocked);

private:
  std::shared_ptr<SimulatedShared> shared_;
};

} // namespace naocal
