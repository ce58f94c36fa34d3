#pragma once

#include "hardware/CameraInterface.hpp"
#include "hardware/simulated/SimulatedPicture.hpp"

namespace naocal {

/// When a simulated camera takes pictures, which of them get lost, and which one waits for the program. Knows nothing
/// of threads.
class SimulatedCamera {
public:
  /// `first`: when its first picture begins.
  SimulatedCamera(CameraName name, const SimulatedPlan& plan, TimePoint first);

  /// A picture whose bytes have come over by `now`: when it began. Asked again until there is none.
  std::optional<TimePoint> arrivedBy(TimePoint now);

  /// Shows the program the picture that `arrivedBy` told of, if the driver does not lose it.
  void deliver(const std::vector<Eigen::Isometry3d>& worldFromCamera);

  /// From the beginning of the first row's exposure to the end of the last row's.
  std::chrono::nanoseconds span() const;

  std::optional<CameraFrame> pending; // newest that was not given yet
  CameraLink link;
  bool blocked = false;

private:
  void schedule();

  CameraName name_;
  SimulatedCameraPlan plan_;
  std::uint64_t seed_;
  Randomness chance_;
  TimePoint first_, begins_; // of the next picture
  std::uint64_t sequence_ = 0;
  std::shared_ptr<const SimulatedLens> lens_;
};

} // namespace naocal
