#include "hardware/v4l2/VideoDevice.hpp"

#include "hardware/v4l2/VideoSystem.hpp"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <linux/usb/video.h>
#include <linux/uvcvideo.h>
#include <linux/videodev2.h>
#include <thread>

namespace naocal {
namespace {

constexpr int tries = 3;
constexpr std::chrono::milliseconds betweenTries{20}; // NAO's cameras react one frame later

/// Repeats a setting until it reads back correctly; returns the reason of a failure, else empty. `set` and `get` return
/// the kernel's result.
template <typename Set, typename Get> std::string insist(const Set& set, const Get& get, int wanted) {
  std::string reason;
  for (int attempt = 0; attempt < tries; ++attempt) {
    if (attempt > 0) {
      std::this_thread::sleep_for(betweenTries);
    }
    int now = 0;
    int result = set();
    result = result < 0 ? result : get(now);
    if (result >= 0 && now == wanted) {
      return "";
    }
    reason = result < 0 ? std::strerror(-result) : fmt::format("it stays at {}", now).c_str();
  }
  return reason;
}

constexpr std::chrono::milliseconds betweenOpenings{100};
constexpr std::chrono::seconds hung{1}; // without an image; a known fault of NAO's cameras

class CapturedBytes : public ImageBytes {
public:
  explicit CapturedBytes(std::span<const std::uint8_t> bytes) : bytes_{bytes.begin(), bytes.end()} {}
  std::span<const std::uint8_t> bytes() const override { return bytes_; }

private:
  std::vector<std::uint8_t> bytes_;
};

} // namespace

VideoDevice::VideoDevice(VideoOptions options, VideoSystem& system) : options_{std::move(options)}, system_{system} {
  link.problem = fmt::format("{}: not opened yet", options_.path);
}

VideoDevice::~VideoDevice() {
  close();
}

void VideoDevice::ensureOpen() {
  if (file_ >= 0 || Clock::now() < nextAttempt_) {
    return;
  }
  try {
    open();
    link.reopened += openedBefore_;
    openedBefore_ = true;
  } catch (const VideoError& error) {
    closeWithReason(error.what());
  }
  nextAttempt_ = Clock::now() + betweenOpenings; // counted from the end: opening can take seconds and blocks the other
                                                 // camera
}

void VideoDevice::open() {
  file_ = checkCall(system_.open(options_.path), "it cannot be opened");
  negotiate();
  buffers_ = std::make_unique<VideoBuffers>(system_, file_, options_.buffers);
  link.problem.clear();
  apply();
  int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  checkCall(system_.ioctl(file_, VIDIOC_STREAMON, &type), "it does not start");
  driverSequence_.reset();
  lastPicture_ = Clock::now();
}

void VideoDevice::negotiate() {
  int input = options_.input;
  system_.ioctl(file_, VIDIOC_S_INPUT, &input); // fails on drivers with a single input: ignored
  v4l2_format format{};
  format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  format.fmt.pix.width = std::uint32_t(options_.width);
  format.fmt.pix.height = std::uint32_t(options_.height);
  format.fmt.pix.pixelformat = V4L2_PIX_FMT_YUYV;
  format.fmt.pix.field = V4L2_FIELD_NONE;
  checkCall(system_.ioctl(file_, VIDIOC_S_FMT, &format), "it refuses a picture format");
  const v4l2_pix_format& got = format.fmt.pix;
  if (int(got.width) != options_.width || int(got.height) != options_.height || got.pixelformat != V4L2_PIX_FMT_YUYV ||
      int(got.bytesperline) != 2 * options_.width) {
    throw VideoError{fmt::format("it offers {} x {} pixels in {} bytes a row instead of {} x {} in YUYV", got.width,
                                 got.height, got.bytesperline, options_.width, options_.height)};
  }
  v4l2_streamparm rate{};
  rate.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  rate.parm.capture.timeperframe = {1, std::uint32_t(options_.framesPerSecond)};
  system_.ioctl(file_, VIDIOC_S_PARM, &rate); // failure ignored; the time stamps show the actual rate
}

void VideoDevice::close() {
  if (file_ >= 0) {
    int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    system_.ioctl(file_, VIDIOC_STREAMOFF, &type);
    buffers_.reset();
    system_.close(file_);
    file_ = -1;
  }
}

void VideoDevice::closeWithReason(const std::string& why) {
  close();
  link.problem = fmt::format("{} ({} camera): {}", options_.path, toString(options_.camera), why);
}

void VideoDevice::drain() {
  try {
    v4l2_buffer buffer{};
    while (buffers_ && buffers_->dequeue(buffer)) {
      accept(buffer);
      buffers_->enqueue(buffer);
    }
    if (buffers_ && Clock::now() - lastPicture_ > hung) {
      closeWithReason("it has given no picture for a second");
    }
  } catch (const VideoError& error) {
    closeWithReason(error.what());
  }
}

void VideoDevice::accept(const v4l2_buffer& buffer) {
  // The driver counts exposed images in 32 bits; a reopened stream restarts the count.
  const auto step = driverSequence_ ? static_cast<std::int32_t>(buffer.sequence - *driverSequence_) : 1;
  const std::uint64_t gap = step > 1 ? static_cast<std::uint64_t>(step - 1) : 0; // ignores steps backwards
  driverSequence_ = buffer.sequence;
  link.lost += gap;
  sequence_ += gap;
  const std::uint64_t sequence = sequence_++;
  lastPicture_ = Clock::now();
  const std::span<const std::uint8_t> bytes = buffers_->bytes(buffer);
  if ((buffer.flags & V4L2_BUF_FLAG_ERROR) ||
      bytes.size() != 2 * std::size_t(options_.width) * std::size_t(options_.height)) {
    ++link.broken;
    return;
  }
  link.skipped += pending.has_value();
  pending = {options_.camera,
             PixelFormat::yuyv,
             options_.width,
             options_.height,
             stamp(buffer),
             sequence,
             std::make_shared<CapturedBytes>(bytes)};
}

/// Most drivers stamp with the monotonic clock and flag it; a V5's uses the wall clock without a flag.
TimePoint VideoDevice::stamp(const v4l2_buffer& buffer) {
  const Duration since =
      std::chrono::seconds{buffer.timestamp.tv_sec} + std::chrono::microseconds{buffer.timestamp.tv_usec};
  if ((buffer.flags & V4L2_BUF_FLAG_TIMESTAMP_MASK) == V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC) {
    return TimePoint{since};
  }
  wallClock_.sampleNow();
  const TimePoint now = Clock::now();
  const auto converted = wallClock_.convert(since, now);
  link.undated += !converted;
  return converted.value_or(now);
}

void VideoDevice::setControls(std::vector<VideoControl> controls) {
  options_.controls = std::move(controls);
  if (file_ >= 0) {
    link.problem.clear();
    apply();
  }
}

/// Applies all settings; `link.problem` keeps the last refusal. Images are taken anyway.
void VideoDevice::apply() {
  const auto note = [&](const std::string& refused) {
    if (!refused.empty()) {
      link.problem = fmt::format("{} ({} camera): {}", options_.path, toString(options_.camera), refused);
    }
  };
  for (const VideoExtension& extension : options_.extensions) {
    note(refusal(extension));
  }
  for (const VideoControl& control : options_.controls) {
    note(refusal(control));
  }
}

std::string VideoDevice::refusal(const VideoControl& control) {
  v4l2_queryctrl range{};
  range.id = control.id;
  if (system_.ioctl(file_, VIDIOC_QUERYCTRL, &range) < 0 || (range.flags & V4L2_CTRL_FLAG_DISABLED)) {
    return fmt::format("it has no {}", control.name);
  }
  if (control.value < range.minimum || control.value > range.maximum) {
    return fmt::format("its {} can be {} to {}, not {}", control.name, range.minimum, range.maximum, control.value);
  }
  v4l2_control value{control.id, control.value};
  const std::string reason = insist(
      [&] {
        value.value = control.value;
        return system_.ioctl(file_, VIDIOC_S_CTRL, &value);
      },
      [&](int& now) {
        const int result = system_.ioctl(file_, VIDIOC_G_CTRL, &value);
        now = value.value;
        return result;
      },
      control.value);
  return reason.empty() ? ""
                        : fmt::format("its {} does not take the value {}: {}", control.name, control.value, reason);
}

std::string VideoDevice::refusal(const VideoExtension& extension) {
  std::uint16_t value = 0;
  const auto query = [&](std::uint8_t what) {
    uvc_xu_control_query request{extension.unit, extension.selector, what, sizeof value,
                                 reinterpret_cast<std::uint8_t*>(&value)}; // little endian, as on every NAO
    return system_.ioctl(file_, UVCIOC_CTRL_QUERY, &request);
  };
  const std::string reason = insist(
      [&] {
        value = extension.value;
        return query(UVC_SET_CUR);
      },
      [&](int& now) {
        value = 0;
        const int result = query(UVC_GET_CUR);
        now = value;
        return result;
      },
      extension.value);
  return reason.empty() ? ""
                        : fmt::format("its {} does not take the value {}: {}", extension.name, extension.value, reason);
}

} // namespace naocal
