#pragma once

#include "framework/core/Clock.hpp"
#include "hardware/CameraInterface.hpp"
#include "hardware/v4l2/VideoBuffers.hpp"
#include "hardware/v4l2/VideoOptions.hpp"

#include <memory>

namespace naocal {

/// One camera behind V4L2: opens it, sets it up, takes its newest picture, and starts anew whatever happens to it. Used
/// by one thread; nothing throws.
class VideoDevice {
public:
  VideoDevice(VideoOptions options, VideoSystem& system);
  ~VideoDevice();
  VideoDevice(const VideoDevice&) = delete;
  VideoDevice& operator=(const VideoDevice&) = delete;

  /// Opens what is closed, a tenth of a second after the last attempt has ended or later.
  void ensureOpen();

  /// Takes all pictures that are ready; the newest becomes `pending`. Closes what has none and has given none for a
  /// second.
  void drain();

  /// Closes; the next `ensureOpen` begins anew. `why`: the end of a sentence.
  void closeWithReason(const std::string& why);

  /// New settings, at once where it is open and from now on; what the camera refuses stands in `link.problem`.
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
  std::optional<std::uint32_t> driverSequence_; // of the last buffer since it was opened
  std::uint64_t sequence_ = 0;                  // of the next one
  ClockOffset wallClock_;
};

} // namespace naocal
