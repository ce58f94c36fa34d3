#pragma once

#include "hardware/v4l2/VideoDevice.hpp"

#include <vector>

namespace naocal {

/// A NAO's cameras: V4L2, mmap buffers, YUYV. Of each camera the newest picture wins; a camera that vanishes, hangs or
/// fails is opened anew while the other one goes on.
class VideoCameras : public CameraInterface {
public:
  explicit VideoCameras(const std::vector<VideoOptions>& cameras, VideoSystem& system = kernelVideoSystem());

  std::optional<CameraFrame> waitForFrame(std::chrono::milliseconds timeout) override;
  CameraStatus status(CameraName camera) const override;

  /// Beside what the model's cameras need. Each setting that must be tried again takes 20 ms.
  void configure(CameraName camera, const std::map<std::string, int>& settings) override;

  /// New settings of a camera instead of those that it had, in the camera loop's thread.
  void setControls(CameraName camera, const std::vector<VideoControl>& controls);

private:
  bool wait(std::chrono::nanoseconds most);

  VideoSystem& system_;
  std::vector<std::unique_ptr<VideoDevice>> devices_;
  std::vector<VideoOptions> cameras_; // as they were made
};

} // namespace naocal
