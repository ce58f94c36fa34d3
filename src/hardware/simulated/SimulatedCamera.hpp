#pragma once

#include "hardware/CameraInterface.hpp"
#include "hardware/simulated/SimulatedPlan.hpp"

#include <Eigen/Geometry>
#include <mutex>

namespace naocal {

/// Optical properties shared by all images of one simulated camera.
struct SimulatedOptics {
  Renderer renderer;
  Appearance appearance;
  std::vector<Board> boards;
  double exposureShare; // exposure / (exposure + read-out)
};

/// An image rendered on first access.
class SimulatedImage : public ImageBytes {
public:
  /// `worldFromCamera`: camera poses at evenly spaced instants, from the first row's start to the last row's end of
  /// exposure.
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

/// Schedule of a simulated camera: exposure times, lost images and the pending image. Not thread-safe.
class SimulatedCamera {
public:
  /// `first`: start of the first exposure.
  SimulatedCamera(CameraName name, const SimulatedPlan& plan, TimePoint first);

  /// The start of exposure of an image whose transfer is complete by `now`. Call it until it is absent.
  std::optional<TimePoint> nextArrival(TimePoint now);

  /// Makes the image of `nextArrival` pending, unless the driver loses it.
  void deliver(const std::vector<Eigen::Isometry3d>& worldFromCamera);

  /// From the start of the first row's exposure to the end of the last row's.
  std::chrono::nanoseconds span() const;

  std::optional<CameraFrame> pending; // newest image not yet taken
  CameraStatus link;
  bool blocked = false;

private:
  void schedule();

  CameraName name_;
  SimulatedCameraPlan plan_;
  std::uint64_t seed_;
  RandomStream chance_;
  TimePoint first_, begins_; // of the next picture
  std::uint64_t sequence_ = 0;
  std::shared_ptr<const SimulatedOptics> lens_;
};

} // namespace naocal
