#pragma once

#include "hardware/v4l2/VideoDevice.hpp"

#include <vector>

namespace naocal {

/// A NAO's cameras: V4L2, mmap buffers, YUYV. The newest image of each camera wins; a camera that vanishes, hangs or
/// fails is reopened while the other one continues.
class VideoCameras : public CameraInterface {
public:
  explicit VideoCameras(const std::vector<VideoOptions>& cameras, VideoSystem& system = kernelVideoSystem());

  std::optional<CameraFrame> waitForFrame(std::chrono::milliseconds timeout) override;
  CameraStatus status(CameraName camera) const override;

  /// Adds settings to those of the robot model. Each retry of a setting takes 20 ms.
  void configure(CameraName camera, const std::map<std::string, int>& settings) override;

  /// Replaces a camera's settings. Call it in the camera loop's thread.
  void setControls(CameraName camera, const std::vector<VideoControl>& controls);

private:
  bool wait(std::chrono::nanoseconds most);

  VideoSystem& system_;
  std::vector<std::unique_ptr<VideoDevice>> devices_;
  std::vector<VideoOptions> cameras_; // options at construction
};

} // namespace naocal
