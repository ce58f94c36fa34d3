#pragma once

#include "hardware/CameraInterface.hpp"
#include "hardware/RobotInterface.hpp"
#include "hardware/simulated/SimulatedPlan.hpp"

#include <memory>

namespace naocal {

struct SimulatedShared;

/// A simulated robot before its boards: one truth behind two interfaces, for two threads. Time advances in
/// `waitForState`, so the camera loop waits in vain where nobody runs the motion loop.
class SimulatedWorld {
public:
  /// `drawing`: of the plan's model.
  SimulatedWorld(const Robot& drawing, const SimulatedPlan& plan);
  ~SimulatedWorld();
  SimulatedWorld(const SimulatedWorld&) = delete;
  SimulatedWorld& operator=(const SimulatedWorld&) = delete;

  /// Its two sides, each for one thread; they may outlive it. With `Pace::quick` the world waits for the camera
  /// loop as long as `cameras` lives, but not longer than a few seconds for a loop that does nothing.
  std::unique_ptr<RobotInterface> robot();
  std::unique_ptr<CameraInterface> cameras();

  /// What nobody told the robot.
  const SimulatedErrors& errors() const;

  /// What is so at this moment; from any thread.
  struct Truth {
    TimePoint time;
    Eigen::VectorXd joints; // of the drawing [rad]
    Eigen::Isometry3d worldFromTorso;
    SupportFoot supportFoot = SupportFoot::both;
    bool fallen = false;
  };
  Truth truth() const;

  /// The joints as they really were, between quarters of cycles linearly; absent beyond the last second. From any
  /// thread.
  std::optional<Eigen::VectorXd> jointsAt(TimePoint time) const;

  /// Somebody touches the robot, until told otherwise; from any thread.
  void touch(const Touch& touch);

  /// A camera gives no pictures, until told otherwise; from any thread.
  void block(CameraName camera, bool blocked);

private:
  std::shared_ptr<SimulatedShared> shared_;
};

} // namespace naocal
