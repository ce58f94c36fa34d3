#pragma once

#include "framework/core/Clock.hpp"
#include "hardware/CameraInterface.hpp"
#include "hardware/v4l2/VideoBuffers.hpp"
#include "hardware/v4l2/VideoOptions.hpp"

#include <memory>

namespace naocal {

/// One V4L2 camera: opens and configures it, takes its newest image, and reopens it after any failure. For a single
/// thread; nothing throws.
class VideoDevice {
public:
  VideoDevice(VideoOptions options, VideoSystem& system);
  ~VideoDevice();
  VideoDevice(const VideoDevice&) = delete;
  VideoDevice& operator=(const VideoDevice&) = delete;

  /// Opens a closed camera, at most once per 100 ms after the last attempt has ended.
  void ensureOpen();

  /// Takes all available images; the newest becomes `pending`. Closes a camera that has delivered nothing for a second.
  void drain();

  /// Closes the camera; the next `ensureOpen` reopens it. `why`: the end of a sentence.
  void closeWithReason(const std::string& why);

  /// Replaces the settings; applies them now if open, and after every reopening. `link.problem` reports refused ones.
  void setControls(std::vector<VideoControl> controls);

  int file() const { return file_; } // -1: closed

  std::optional<CameraFrame> pending;
  CameraStatus link;

private:
  void open();
  void negotiate();
  void close();
  void apply();
  std::string refusal(const VideoControl& control);
  std::string refusal(const VideoExtension& extension);
  void accept(const struct v4l2_buffer& buffer);
  TimePoint stamp(const struct v4l2_buffer& buffer);

  VideoOptions options_;
  VideoSystem& system_;
  int file_ = -1;
  std::unique_ptr<VideoBuffers> buffers_;
  bool openedBefore_ = false;
  TimePoint nextAttempt_{}, lastPicture_{};
  std::optional<std::uint32_t> driverSequence_; // of the last buffer since opening
  std::uint64_t sequence_ = 0;                  // of the next one
  ClockOffset wallClock_;
};

} // namespace naocal
