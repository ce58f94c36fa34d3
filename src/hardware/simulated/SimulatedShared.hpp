#pragma once

#include "hardware/CameraLoopStep.hpp"
#include "hardware/RobotInterface.hpp"
#include "hardware/simulated/SimulatedBody.hpp"
#include "hardware/simulated/SimulatedCamera.hpp"

#include <deque>
#include <mutex>

namespace naocal {

/// What the two sides of a simulated world share. Everything under `mutex`.
struct SimulatedShared {
  SimulatedShared(const Robot& drawing, const SimulatedPlan& plan);

  struct Moment {
    TimePoint time;
    Eigen::VectorXd joints;
    Eigen::Isometry3d worldFromTorso;
  };
  /// Between quarters of cycles linearly; absent beyond the last second.
  std::optional<Moment> momentAt(TimePoint time) const;

  bool picturePending() const { return cameras[0].pending || cameras[1].pending; }

  /// One cycle on: commands that are due, the body, the pictures that have come over.
  void advance();

  static constexpr std::chrono::milliseconds cycle{12};

  const SimulatedPlan plan;
  const Robot drawing;
  const SimulatedErrors errors;
  mutable std::mutex mutex;
  CameraLoopStep step;
  SimulatedBody body;
  TimePoint now;
  std::deque<std::pair<TimePoint, RobotCommand>> commands; // and when they reach the motors
  std::array<SimulatedCamera, 2> cameras;                  // by CameraName
  RobotLink link;
  Touch touched;

private:
  void remember();
  void expose(std::size_t camera, TimePoint begins);

  std::deque<Moment> history_;
};

} // namespace naocal
