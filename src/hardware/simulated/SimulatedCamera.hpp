#pragma once

#include "hardware/CameraInterface.hpp"
#include "hardware/simulated/SimulatedPlan.hpp"

#include <Eigen/Geometry>
#include <mutex>

namespace naocal {

/// What one camera of a simulated robot has in common for all its pictures.
struct SimulatedOptics {
  Renderer renderer;
  Appearance appearance;
  std::vector<Board> boards;
  double exposureShare; // of the time from the first row's beginning to the last row's end
};

/// A picture that is rendered when somebody looks at it.
class SimulatedImage : public ImageBytes {
public:
  /// `worldFromCamera`: at instants evenly spread over the exposure of all rows.
  SimulatedImage(std::shared_ptr<const SimulatedOptics> lens, std::vector<Eigen::Isometry3d> worldFromCamera,
                 std::uint64_t seed);

  std::span<const std::uint8_t> bytes() const override; // YUYV

private:
  RenderedScene scene(const Eigen::Isometry3d& worldFromCamera) const;
  void render() const;

  std::shared_ptr<const SimulatedOptics> lens_;
  std::vector<Eigen::Isometry3d> worldFromCamera_;
  std::uint64_t seed_;
  mutable std::once_flag rendered_;
  mutable std::vector<std::uint8_t> bytes_;
};

/// When a simulated camera takes pictures, which of them get lost, and which one waits for the program. Knows nothing
/// of threads.
class SimulatedCamera {
public:
  /// `first`: when its first picture begins.
  SimulatedCamera(CameraName name, const SimulatedPlan& plan, TimePoint first);

  /// A picture whose bytes have come over by `now`: when it began. Asked again until there is none.
  std::optional<TimePoint> nextArrival(TimePoint now);

  /// Shows the program the picture that `nextArrival` told of, if the driver does not lose it.
  void deliver(const std::vector<Eigen::Isometry3d>& worldFromCamera);

  /// From the beginning of the first row's exposure to the end of the last row's.
  std::chrono::nanoseconds span() const;

  std::optional<CameraFrame> pending; // newest that was not given yet
  CameraStatus link;
  bool blocked = false;

private:
  void schedule();

  CameraName name_;
  SimulatedCameraPlan plan_;
  std::uint64_t seed_;
  Randomness chance_;
  TimePoint first_, begins_; // of the next picture
  std::uint64_t sequence_ = 0;
  std::shared_ptr<const SimulatedOptics> lens_;
};

} // namespace naocal
